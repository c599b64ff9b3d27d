// SPDX-License-Identifier: BSD-3-Clause
// A picture whose axis is not in its middle: a part of a larger one.
#ifndef WideFoVBorders_h
#define WideFoVBorders_h

#include "vtkWideFoVAbi.h"

#include "OptionCheck.h"
#include "Options.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkScalarBarActor;
VTK_ABI_NAMESPACE_END

namespace widefov
{
// Sets the fields of view of the whole picture, which has the axis in its middle, and which part of
// it is drawn; where no size is given, a height with which the map is not stretched. Throws a
// Failure with ExitUsage where the borders do not fit the projection or other options.
void TakeBorders(Options& options, const wfv::Projection& projection, const FieldsOfView& given);

// Moves a bar from its place in the whole picture to the same one in the part.
void PlaceInPart(vtkScalarBarActor* bar, const Options& options);
}

#endif
