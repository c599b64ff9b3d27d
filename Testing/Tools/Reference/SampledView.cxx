// SPDX-License-Identifier: BSD-3-Clause
#include "SampledView.h"

namespace wfv
{
namespace reference
{
std::shared_ptr<const DirectionMap> SampleView(const View& view, int width, int height)
{
  std::vector<float> directions;
  directions.reserve(3 * std::size_t(width) * height);
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
}
}
