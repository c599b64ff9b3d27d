// SPDX-License-Identifier: BSD-3-Clause
#include "SampledMap.h"

#include "DirectionTables.h"

namespace wfv
{
namespace test
{
bool Boxes::Hold(const vec2& ndc) const
{
  const auto in = [&](const vec4& r) {
    return ndc.x >= r.x && ndc.x <= r.z && ndc.y >= r.y && ndc.y <= r.w;
  };
  return in(this->First) || in(this->Second);
}

Boxes CapBoxes(const vec3& centre, double angle, const WfvView& view)
{
  const tables::WfvPlaces places = tables::wfvCapPlaces(centre, angle, view);
  return { places.first, places.second };
}
}
}
