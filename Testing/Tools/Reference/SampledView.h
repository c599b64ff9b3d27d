// SPDX-License-Identifier: BSD-3-Clause
// What a view shows, as a direction map: the same rays without a formula.
#ifndef WideFoVSampledView_h
#define WideFoVSampledView_h

#include "Projections/DirectionMap.h"

#include <memory>

namespace wfv
{
namespace reference
{
// The rays of a view, at the pixels of a picture of this size.
std::shared_ptr<const DirectionMap> SampleView(const View& view, int width, int height);
}
}

#endif
