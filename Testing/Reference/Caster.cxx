// SPDX-License-Identifier: BSD-3-Clause
#include "Caster.h"

#include <vtkSMPTools.h>

namespace wfv
{
namespace reference
{
vec2 PixelToNdc(double x, double y, int width, int height)
{
  return vec2(2 * x / width - 1, 1 - 2 * y / height);
}

Hit Caster::Cast(vec2 ndc) const
{
  const ViewRay ray = this->TheView.Ray(ndc);
  if (!ray.Inside)
  {
    return {};
  }
  Hit hit = this->Cast(ray.Origin, ray.Direction);
  hit.InDomain = true;
  return hit;
}

HitPicture Caster::Render(int width, int height) const
{
  HitPicture picture;
  picture.Width = width;
  picture.Height = height;
  picture.Hits.resize(std::size_t(width) * height);
  vtkSMPTools::For(0, height, 1, [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType j = begin; j < end; ++j)
    {
      for (int i = 0; i < width; ++i)
      {
        picture.Hits[j * width + i] = this->Cast(PixelToNdc(i + 0.5, j + 0.5, width, height));
      }
    }
  });
  return picture;
}
}
}
