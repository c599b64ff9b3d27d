// SPDX-License-Identifier: BSD-3-Clause
// Where a ray enters and leaves a ball, a cylinder with flat ends, and the hull of two
// balls, in double: the textbook quadratic equations. All three are convex.
#ifndef WideFoVRayQuadric_h
#define WideFoVRayQuadric_h

#include "Projections/ProjectionMath.h"

#include <limits>

namespace wfv
{
namespace reference
{
struct Body
{
  enum class Shape
  {
    Ball,  // about P, of radius R
    Stick, // from P to Q, radius R, flat ends
    Hull   // of the balls (P, R) and (Q, S)
  };
  Shape Kind = Shape::Ball;
  vec3 P{ 0 };
  vec3 Q{ 0 };
  double R = 0;
  double S = 0;
};

// The crossings of a line with a body; Entry > Exit where it misses.
struct Crossings
{
  double Entry = std::numeric_limits<double>::infinity(); // along the line, scene units
  double Exit = -std::numeric_limits<double>::infinity();
  vec3 EntryNormal{ 0 }; // outwards, unit length
  vec3 ExitNormal{ 0 };

  bool Hit() const { return this->Entry <= this->Exit; }

  // Widens the interval by a point of the surface.
  void Add(double t, const vec3& normal)
  {
    if (t < this->Entry)
    {
      this->Entry = t;
      this->EntryNormal = normal;
    }
    if (t > this->Exit)
    {
      this->Exit = t;
      this->ExitNormal = normal;
    }
  }
};

// Both roots of a t^2 + 2 b t + c, without cancellation; false where there is none.
inline bool SolveQuadratic(double a, double b, double c, double roots[2])
{
  const double discriminant = b * b - a * c;
  if (!(discriminant >= 0) || a == 0)
  {
    return false;
  }
  const double q = -(b + std::copysign(std::sqrt(discriminant), b));
  roots[0] = q / a;
  roots[1] = q != 0 ? c / q : q / a;
  return true;
}

inline void AddBall(
  Crossings& crossings, const vec3& o, const vec3& d, const vec3& centre, double radius)
{
  const vec3 w = o - centre;
  double roots[2];
  if (SolveQuadratic(glm::dot(d, d), glm::dot(w, d), glm::dot(w, w) - radius * radius, roots))
  {
    for (const double t : roots)
    {
      crossings.Add(t, (w + d * t) / radius);
    }
  }
}

// The lateral surface |y - z a| = radius + slope z, z = y . a in [low, high], y from P.
inline void AddCone(Crossings& crossings, const vec3& o, const vec3& d, const vec3& p,
  const vec3& axis, double radius, double slope, double low, double high)
{
  const vec3 w = o - p;
  const double wz = glm::dot(w, axis);
  const double dz = glm::dot(d, axis);
  const vec3 wp = w - axis * wz;
  const vec3 dp = d - axis * dz;
  const double r = radius + slope * wz;
  double roots[2];
  if (!SolveQuadratic(glm::dot(dp, dp) - slope * slope * dz * dz, glm::dot(wp, dp) - slope * dz * r,
        glm::dot(wp, wp) - r * r, roots))
  {
    return;
  }
  for (const double t : roots)
  {
    const double z = wz + t * dz;
    if (z >= low && z <= high && radius + slope * z >= 0)
    {
      crossings.Add(t, glm::normalize((wp + dp * t) / (radius + slope * z) - axis * slope));
    }
  }
}

inline void AddEnd(Crossings& crossings, const vec3& o, const vec3& d, const vec3& centre,
  const vec3& normal, double radius)
{
  const double speed = glm::dot(d, normal);
  const double t = glm::dot(centre - o, normal) / speed;
  const vec3 from = o + d * t - centre;
  if (speed != 0 && glm::dot(from, from) <= radius * radius)
  {
    crossings.Add(t, normal);
  }
}

// The direction has unit length.
inline Crossings Cross(const Body& b, const vec3& o, const vec3& d)
{
  Crossings crossings;
  const double length = glm::length(b.Q - b.P);
  if (b.Kind != Body::Shape::Stick)
  {
    AddBall(crossings, o, d, b.P, b.R);
  }
  if (b.Kind == Body::Shape::Hull)
  {
    AddBall(crossings, o, d, b.Q, b.S);
    if (length > std::abs(b.R - b.S))
    {
      // the circles in which the cone touches the balls
      const double s = (b.R - b.S) / length;
      const double c = std::sqrt(1 - s * s);
      AddCone(
        crossings, o, d, b.P, (b.Q - b.P) / length, b.R / c, -s / c, b.R * s, length + b.S * s);
    }
  }
  if (b.Kind == Body::Shape::Stick)
  {
    const vec3 axis = (b.Q - b.P) / length;
    AddCone(crossings, o, d, b.P, axis, b.R, 0, 0, length);
    AddEnd(crossings, o, d, b.P, -axis, b.R);
    AddEnd(crossings, o, d, b.Q, axis, b.R);
  }
  return crossings;
}
}
}

#endif
