// SPDX-License-Identifier: BSD-3-Clause
// Surfaces that projectors light. Metres, room coordinates: x right, y up, looking down -z.
#ifndef WideFoVDisplaysSurface_h
#define WideFoVDisplaysSurface_h

#include "Calibration.h"

#include <limits>
#include <memory>

namespace wfv::displays
{
class Surface
{
public:
  static constexpr double Nowhere = std::numeric_limits<double>::infinity();

  virtual ~Surface() = default;

  // Distance along a ray of unit direction to the surface; Nowhere where the ray misses it.
  virtual double Meet(const vec3& origin, const vec3& direction) const = 0;
};

// A sphere, or the part of it whose angle from an axis is at most HalfAngle: a dome.
struct SphereSurface : Surface
{
  vec3 Center{ 0 };
  double Radius = 1;
  vec3 Axis{ 0, 1, 0 };   // unit length
  double HalfAngle = 180; // degrees
  double Meet(const vec3& origin, const vec3& direction) const override;
};

// An upright cylinder, or the part of it round its front, -z.
struct CylinderSurface : Surface
{
  vec3 Center{ 0 }; // on the axis, at the height from which Low and High count
  double Radius = 1;
  double Low = -1; // metres
  double High = 1;
  double HalfAngle = 180; // degrees to the left and right of the front
  double Meet(const vec3& origin, const vec3& direction) const override;
};

// A rectangle, as a screen of a room is given: three of its corners.
struct PlaneSurface : Surface
{
  vec3 LowerLeft{ -1, -1, -1 };
  vec3 LowerRight{ 1, -1, -1 };
  vec3 UpperRight{ 1, 1, -1 };
  double Meet(const vec3& origin, const vec3& direction) const override;
};

// The triangles of an OBJ file, in a hierarchy of boxes of the library's own: in double, where
// Embree has floats, and with no other library to install. Throws a FileError.
std::unique_ptr<Surface> ReadSurface(const std::string& path);
}

#endif
