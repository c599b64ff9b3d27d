// SPDX-License-Identifier: BSD-3-Clause
// A picture whose axis is not in its middle: a part of a larger one.
#ifndef WideFoVBorders_h
#define WideFoVBorders_h

#include "FieldsOfView.h"
#include "Options.h"

#include <array>

namespace widefov
{
// Sets the fields of view of the whole picture, which has the axis in its middle, and which part of
// it is drawn; where no size is given, a height with which the map is not stretched. Throws a
// Failure with ExitUsage where the borders do not fit the projection or other options.
void TakeBorders(Options& options, const wfv::Projection& projection, const FieldsOfView& given);

// Can the projection's pictures have such borders?
bool HasBorders(const wfv::Projection& projection);

// Of a picture that is a part: the pixels of it and of the whole for the options' size, and the
// whole's aspect.
void FitPart(Options& options);

// The same place as NDC of the whole, of NDC of what is drawn.
wfv::vec2 InWhole(const Options& options, const wfv::vec2& ndc);

// Angles of the borders from the axis, as --borders takes them. Only of a picture that is a part.
std::array<double, 4> BordersOf(const Options& options);
}

#endif
