// SPDX-License-Identifier: BSD-3-Clause
// What a pixel of a direction map shows beside it, in double. Such a map may be torn anywhere, so
// lines and points are drawn, in each pixel, as its own map would show them if it went on as its
// directions change inside the pixel: the plane of its ray and its slopes. Slopes are differences
// of the view's rays, inside the pixel.
#ifndef WideFoVOwnMap_h
#define WideFoVOwnMap_h

#include "Projections/Projection.h"

namespace wfv
{
namespace reference
{
class OwnMap
{
public:
  // Of column i and row j, from the top, of a picture of the direction map's own size.
  OwnMap(const View& view, int i, int j, int width, int height);

  // It shows something, and has slopes.
  bool IsShown() const { return this->Shown; }

  // Pixels to the right and up from the pixel's centre; infinite behind.
  vec2 PlaceOf(const vec3& direction) const;

  // Of the plane, on the side that the ray goes to.
  const vec3& GetNormal() const { return this->Normal; }

private:
  vec3 Normal{ 0 };
  glm::dmat3 ToMap{ 1 };
  bool Shown = false;
};
}
}

#endif
