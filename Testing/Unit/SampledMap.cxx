// SPDX-License-Identifier: BSD-3-Clause
#include "SampledMap.h"

#include "DirectionTables.h"

namespace wfv
{
namespace test
{
std::shared_ptr<const DirectionMap> SampleView(const View& view, int width, int height)
{
  std::vector<float> directions;
  for (int y = 0; y < height; y++)
  {
    for (int x = 0; x < width; x++)
    {
      const vec2 ndc(2 * (x + 0.5) / width - 1, 2 * (y + 0.5) / height - 1);
      const ViewRay ray = view.Ray(ndc);
      for (int i = 0; i < 3; i++)
      {
        directions.push_back(ray.Inside ? static_cast<float>(ray.Direction[i]) : 0.f);
      }
    }
  }
  return std::make_shared<const DirectionMap>(width, height, directions);
}

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
