// SPDX-License-Identifier: BSD-3-Clause
// Convex polygons in the picture's tangent plane at one pixel, where great circles are
// straight: what triangles look like from the eye, cut and taken from one another.
#ifndef WideFoVTangentFrame_h
#define WideFoVTangentFrame_h

#include "Caster.h"

#include <array>
#include <vector>

namespace wfv
{
namespace reference
{
// Convex, counterclockwise, pixels from the pixel's centre; empty: nothing.
using Polygon = std::vector<vec2>;

// Square pixels: a smaller polygon is nothing. Far above the rounding of places within
// SearchLimit, and a needle of this area is a hundred pixels long and 1e-12 wide.
constexpr double LeastArea = 1e-10;

// The picture near a pixel, to first order: the ray's direction and what it changes by
// from pixel to pixel.
class TangentFrame
{
public:
  TangentFrame(const View& view, int width, int height, vec2 place);

  // False where the map has no ray there, or is flat.
  bool IsValid() const { return this->Valid; }

  // Of so many pixels beside the place; not of unit length.
  vec3 DirectionAt(vec2 pixels) const;

  // The part of a triangle that is within so many pixels along both axes.
  Polygon PictureOf(const std::array<vec3, 3>& triangle, double reach) const;

  // The same of the part of it on the eye's side of another triangle's plane.
  Polygon PictureBefore(
    const std::array<vec3, 3>& triangle, const std::array<vec3, 3>& other, double reach) const;

  // The part of an edge that is so near, as ways from the eye to places along it in order; some
  // may be there twice. Empty where none is.
  std::vector<vec3> EdgeWithin(const vec3& a, const vec3& b, double reach) const;

private:
  std::vector<vec3> Within(std::vector<vec3> corners, double reach) const;
  Polygon Picture(const std::vector<vec3>& corners, double reach) const;
  bool Valid = false;
  vec3 Origin{ 0 };
  vec3 Ahead{ 0 };
  vec3 Right{ 0 }; // per pixel, across Ahead
  vec3 Down{ 0 };
  vec3 ToRight{ 0 }; // pixels along Right of w: dot(ToRight, w) / dot(Ahead, w)
  vec3 ToDown{ 0 };
};

double Area(const Polygon& polygon);
vec2 Centroid(const Polygon& polygon);
bool Holds(const Polygon& polygon, vec2 point);
vec2 NearestToOrigin(const Polygon& polygon);

// The part of it where dot(normal, p) >= offset.
Polygon Cut(const Polygon& polygon, vec2 normal, double offset);

// What is left of a polygon without another one, in convex parts.
std::vector<Polygon> Without(const Polygon& polygon, const Polygon& other);

// The two halves of it across its longest extent.
std::vector<Polygon> Halves(const Polygon& polygon);
}
}

#endif
