// SPDX-License-Identifier: BSD-3-Clause
// Direction maps for the tests.
#ifndef WideFoVTestSampledMap_h
#define WideFoVTestSampledMap_h

#include "DirectionMap.h"

#include <memory>

namespace wfv
{
namespace test
{
// The rays of a view, at the pixels of a picture of this size.
std::shared_ptr<const DirectionMap> SampleView(const View& view, int width, int height);

// Where a cap of the sphere may be seen (wfvCapPlaces).
struct Boxes
{
  vec4 First;
  vec4 Second;
  bool Hold(const vec2& ndc) const;
};

Boxes CapBoxes(const vec3& centre, double angle, const WfvView& view);
}
}

#endif
