// SPDX-License-Identifier: BSD-3-Clause
#include "NearestFace.h"

#include "NearestPlace.h"
#include "Projections/Bounds/ChordLimits.h"

#include <algorithm>
#include <cmath>

namespace wfv
{
namespace reference
{
namespace
{
// Places of an edge, and how often those round the nearest are looked at as closely again.
constexpr int Steps = 256;
constexpr int Rounds = 4;

// Of the picture: places of an edge that are farther apart than this are torn by the map.
constexpr double Torn = 0.25;

// Relative, of the clip spheres: pieces are clipped at distances interpolated along chords.
constexpr double ClipRounding = ChordLimits::LongestChord * ChordLimits::LongestChord / 8;

// Relative to its other end: nearer ends of an edge are one.
constexpr double LeastAngle = 1e-12;

class Edge
{
public:
  Edge(const View& view, int width, int height, const vec3& a, const vec3& b)
    : TheView(view)
    , Size(width, height)
    , A(a)
    , B(b)
    , Angle(std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)))
  {
  }

  // Of the places from the share `from` of its angle on.
  double DistanceTo(vec2 place, double from, double to, int rounds) const
  {
    const double step = (to - from) / Steps;
    double nearest = std::numeric_limits<double>::infinity();
    double at = from;
    for (int i = 0; i < Steps; ++i)
    {
      const double here = this->DistanceOfPiece(place, from + i * step, from + (i + 1) * step);
      at = here < nearest ? from + i * step : at;
      nearest = std::min(here, nearest);
    }
    const bool closer = rounds > 0 && std::isfinite(nearest);
    return closer
      ? this->DistanceTo(place, std::max(0.0, at - step), std::min(1.0, at + 2 * step), rounds - 1)
      : nearest;
  }

private:
  vec3 PointAt(double share) const
  {
    if (!(this->Angle > LeastAngle))
    {
      return this->A + share * (this->B - this->A);
    }
    const double a = std::sin((1 - share) * this->Angle) / glm::length(this->A);
    const double b = std::sin(share * this->Angle) / glm::length(this->B);
    return (a * this->A + b * this->B) / (a + b);
  }

  // False where it is clipped.
  bool PlaceAt(double share, vec2& place) const
  {
    const vec3 point = this->PointAt(share);
    const vec2 radii = this->TheView.GetParameters().radii;
    const double away = glm::length(point);
    const vec3 ndc = this->TheView.Forward(point).Ndc;
    place = vec2(0.5 * (ndc.x + 1) * this->Size.x, 0.5 * (1 - ndc.y) * this->Size.y);
    return away >= radii.x * (1 - ClipRounding) && away <= radii.y * (1 + ClipRounding);
  }

  double DistanceOfPiece(vec2 place, double from, double to) const
  {
    vec2 a;
    vec2 b;
    if (!this->PlaceAt(from, a) || !this->PlaceAt(to, b) ||
      !(glm::length(b - a) < Torn * this->Size.x))
    {
      return std::numeric_limits<double>::infinity();
    }
    const double length2 = std::max(glm::dot(b - a, b - a), 1e-300);
    const double along = std::clamp(glm::dot(place - a, b - a) / length2, 0.0, 1.0);
    return glm::length(a + along * (b - a) - place);
  }

  const View& TheView;
  vec2 Size;
  vec3 A;
  vec3 B;
  double Angle;
};
}

double NearestFace(
  const RayCaster& caster, int width, int height, vec2 place, vtkIdType cell, double limit)
{
  const View& view = caster.GetView();
  const RayCaster alone(OnlyCell(caster.GetTriangles(), cell), view);
  if (alone.Cast(PixelToNdc(place.x, place.y, width, height)).Cell == cell)
  {
    return 0;
  }
  // (the search compares the limit with distances of first order)
  double nearest = NearestPlace(alone, width, height, place, cell, 2 * limit);
  const TriangleSoup& own = alone.GetTriangles();
  for (const auto& t : own.Triangles)
  {
    for (int k = 0; k < 3; ++k)
    {
      const Edge edge(view, width, height, own.Points[t[k]], own.Points[t[(k + 1) % 3]]);
      nearest = std::min(nearest, edge.DistanceTo(place, 0, 1, Rounds));
    }
  }
  return nearest <= limit ? nearest : std::numeric_limits<double>::infinity();
}
}
}
