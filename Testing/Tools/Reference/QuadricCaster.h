// SPDX-License-Identifier: BSD-3-Clause
// Balls, sticks and hulls by ray, one after the other: few and slow, but plain.
#ifndef WideFoVQuadricCaster_h
#define WideFoVQuadricCaster_h

#include "Caster.h"
#include "RayQuadric.h"

#include <vector>

namespace wfv
{
namespace reference
{
class QuadricCaster : public Caster
{
public:
  // Bodies in view coordinates; the index of one is its cell.
  QuadricCaster(const std::vector<Body>& bodies, const View& view);

  // The first crossing between the clip spheres, from inside too, as of a mesh.
  Hit Cast(const vec3& origin, const vec3& direction) const override;
  using Caster::Cast;

  const std::vector<Body>& GetBodies() const { return this->Bodies; }

private:
  std::vector<Body> Bodies;
};

// Side, in radians, of the square that has the solid angle of the pixel about this
// direction (view coordinates): from the view's own ray, by central differences.
double PixelAngle(const View& view, const vec3& direction, int width, int height);
}
}

#endif
