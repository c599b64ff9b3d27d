// SPDX-License-Identifier: BSD-3-Clause
// One line and its image in the map, in double: what LineReference.h samples.
#ifndef WideFoVLineArc_h
#define WideFoVLineArc_h

#include "LineReference.h"

#include <algorithm>
#include <cmath>

namespace wfv
{
namespace reference
{
struct Sample
{
  double Angle = 0;
  vec2 Pixel{ 0 };
  double Rho = 0;
  bool Counts = true; // the map has a place for it
};

// The picture: its size and, of a cube's faces, which one: pixels.
struct Window
{
  double Width = 0;
  double Height = 0;
  double Reach = 0;
  vec2 Low{ 0 };
  vec2 High{ 0 };
};

// Radians: as far as this from the middle of a cube's face its map is carried on.
constexpr double FaceEnd = 1.3;

// The map of one face of a cube, from the rays at its middle and half-way to its borders.
class FaceMap
{
public:
  FaceMap(const View& view, int face)
    : Centre((face % 3 - 1) * 2 / 3., face < 3 ? 0.5 : -0.5)
    , Ahead(view.Ray(this->Centre).Direction)
  {
    const double half = WFV_PI / 8;
    const auto axis = [&](const vec2& step) {
      const vec3 d = view.Ray(this->Centre + step).Direction;
      return (d - std::cos(half) * this->Ahead) / std::sin(half);
    };
    this->Right = axis(vec2(1 / 6., 0));
    this->Up = axis(vec2(0, 0.25));
  }

  vec2 Angles(const vec3& d) const
  {
    const double ahead = glm::dot(d, this->Ahead);
    return vec2(
      std::atan2(glm::dot(d, this->Right), ahead), std::atan2(glm::dot(d, this->Up), ahead));
  }

  bool Has(const vec3& d) const
  {
    const vec2 a = this->Angles(d);
    return std::max(std::abs(a.x), std::abs(a.y)) < FaceEnd;
  }

  vec2 Ndc(const vec3& d) const
  {
    return this->Centre + this->Angles(d) * vec2(4 / WFV_PI / 3, 2 / WFV_PI);
  }

private:
  vec2 Centre;
  vec3 Ahead;
  vec3 Right;
  vec3 Up;
};

// The line as an arc about the eye.
class Arc
{
public:
  // face: of a cube, the one whose map counts; else null.
  Arc(const Segment& segment, const View& view, const Window& window, const FaceMap* face);

  double GetSpan() const { return this->Span; }
  bool IsDots() const { return this->Dots; }
  double GetShortest() const { return this->Shortest; }
  double GetPeriod() const { return this->Period; }
  const Window& GetWindow() const { return this->TheWindow; }
  Sample At(double angle) const;

  // What is seen at an angle where rays begin in one place, of dots at its two ends: its direction,
  // and how far it is away.
  vec3 DirectionAt(double angle) const;
  double RhoAt(double angle) const;

private:
  void SetOwn();
  Sample OwnAt(double angle) const;
  vec3 EndAt(double angle) const;
  void Place(const vec3& point, const vec3& direction, Sample& sample) const;

  const View* TheView;
  const FaceMap* Face;
  Window TheWindow;
  vec3 From;
  vec3 To;
  vec3 First;  // the direction of From
  vec3 Second; // at a right angle to it, towards To
  double Span = 0;
  double Shortest;
  double Period = 0; // pixels, 0 where the map does not close across a straight seam
  bool Dots = false;

  // Of an eye whose rays begin in several places: angles are those from Foot, the point of the
  // line nearest to the middle between the eyes, as seen from as far away as Softened.
  bool Own = false;
  vec3 Foot{ 0 };
  vec3 Along{ 0 };
  double Softened = 0;
  double Begin = 0;
};
}
}

#endif
