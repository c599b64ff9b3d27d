// SPDX-License-Identifier: BSD-3-Clause
// What a picture of lines on a direction map must show, in double, by each pixel's local map
// (OwnMap.h). The nearest point is searched for, which it is not in the shaders.
#ifndef WideFoVSampledLines_h
#define WideFoVSampledLines_h

#include "LineReference.h"

namespace wfv
{
namespace reference
{
// As RenderLines does it for other maps.
LinePicture RenderSampledLines(const std::vector<Segment>& segments, const View& view, int width,
  int height, double reach, double nearest = NearestSlack);
}
}

#endif
