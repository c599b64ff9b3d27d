// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWideFoVTriangleJudge.h"

#include "Projections/Bend.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
using namespace wfv;

// Relative to the distance: so near a discontinuity float32 may place a point beyond it.
constexpr double Beside = 1e-5;

// On the distance of an edge, at its quarters, from its chord, for what lies between.
constexpr double BetweenQuarters = 1.2;

// Radians, and over the distance from a singular point: edges that their quarters say enough of.
constexpr double LongestMeasured = 0.1;
constexpr double PartOfSine = 0.25;

// Sine of the angle under which a triangle is seen edge-on: chords may turn the side round.
constexpr double EdgeOn = 0.02;

// True where a small triangle, whose corners these are, may meet a tear of the map. Poles and
// antipodes are the business of LocalBend, which has no bound there.
bool MayTear(Family family, const vec3 d[3])
{
  if (family == Family::Meridian)
  {
    const double low = std::min({ d[0].x, d[1].x, d[2].x });
    const double high = std::max({ d[0].x, d[1].x, d[2].x });
    return low <= Beside && high >= -Beside && std::max({ d[0].z, d[1].z, d[2].z }) >= 0;
  }
  if (family != Family::Faces)
  {
    return false;
  }
  const vec3 a = glm::abs(d[0]);
  const int axis = a.x >= a.y && a.x >= a.z ? 0 : a.y >= a.z ? 1 : 2;
  const double sign = d[0][axis] < 0 ? -1 : 1;
  for (int i = 0; i < 3; i++)
  {
    const double others = std::max(std::abs(d[i][(axis + 1) % 3]), std::abs(d[i][(axis + 2) % 3]));
    if (!(sign * d[i][axis] > others + Beside))
    {
      return true;
    }
  }
  return false;
}

double Square(double x)
{
  return x * x;
}

double Longest2(const vec3 p[3])
{
  const vec3 a = p[1] - p[0];
  const vec3 b = p[2] - p[1];
  const vec3 c = p[0] - p[2];
  return std::max({ glm::dot(a, a), glm::dot(b, b), glm::dot(c, c) });
}
}

namespace wfv
{
bool SortView::operator==(const SortView& o) const
{
  const WfvView& a = this->View;
  const WfvView& b = o.View;
  return this->Map == o.Map && a.halfFov == b.halfFov && a.scale == b.scale && a.tilt == b.tilt &&
    a.radii == b.radii && a.lens == b.lens && a.lens5 == b.lens5 && a.maxAngle == b.maxAngle &&
    a.map == b.map && this->Part.Low == o.Part.Low && this->Part.High == o.Part.High &&
    this->Pixels == o.Pixels && this->Bends == o.Bends && this->Culls == o.Culls;
}

// A triangle may come nearer than its corners, by an eighth of its angle squared.
TriangleJudge::TriangleJudge(const SortView& view)
  : V(view)
  , Near(view.View.radii.x * (1 + Square(LongestMeasured)))
  , Far(view.View.radii.y * (1 - 10 * Beside))
{
  const vec2 half = 0.5 * view.Pixels;
  this->Scale = half * half / 64.0; // of (a^2 / 8)^2, pixels
}

int TriangleJudge::GetSide(const vec3 q[3])
{
  const vec3 n = glm::cross(q[1] - q[0], q[2] - q[0]);
  const double s = glm::dot(n, q[0]);
  const bool clear = s * s > EdgeOn * EdgeOn * glm::dot(n, n) * glm::dot(q[0], q[0]);
  return !clear ? 0 : s < 0 ? -1 : 1;
}

bool TriangleJudge::IsPlain(const vec3 q[3]) const
{
  vec3 d[3];
  double nearest = std::numeric_limits<double>::max();
  double farthest = 0;
  for (int i = 0; i < 3; i++)
  {
    const double r = std::sqrt(glm::dot(q[i], q[i]));
    nearest = std::min(nearest, r);
    farthest = std::max(farthest, r);
    d[i] = q[i] / r;
  }
  if (!(nearest > this->Near) || !(farthest < this->Far))
  {
    return false;
  }
  const double angle2 = Longest2(d);
  if (angle2 > Square(LongestMeasured) || MayTear(this->V.Map->Axis, d))
  {
    return false;
  }
  const bool local = angle2 <= Square(LocalBend::LongestEdge);
  const double bound2 = this->GetBound2(d, angle2);
  return (local && bound2 <= Square(PlainError)) || this->MeasuresFine(d, angle2);
}

// Of the distance of chords from edges, pixels: a bound, squared.
double TriangleJudge::GetBound2(const vec3 d[3], double angle2) const
{
  double x = 0;
  double y = 0;
  for (int i = 0; i < 3; i++)
  {
    const std::array<float, 2>& bend = this->V.Bends->At(d[i]);
    x = std::max(x, double(bend[0]));
    y = std::max(y, double(bend[1]));
  }
  return angle2 * angle2 * (x * x * this->Scale.x + y * y * this->Scale.y);
}

// The bound of a cell of directions is coarse near poles, and knows no directions of edges.
bool TriangleJudge::MeasuresFine(const vec3 d[3], double angle2) const
{
  const Projection& p = *this->V.Map;
  const vec2 half = 0.5 * this->V.Pixels;
  vec2 at[3];
  for (int i = 0; i < 3; i++)
  {
    const double sine = SineToSingularity(p.Axis, d[i]);
    if (!(angle2 <= Square(PartOfSine * sine)))
    {
      return false;
    }
    at[i] = p.Project(d[i], this->V.View) * half;
  }
  for (int i = 0; i < 3; i++)
  {
    const int j = (i + 1) % 3;
    for (const double t : { 0.25, 0.5, 0.75 })
    {
      const vec3 place = glm::normalize(d[i] * (1 - t) + d[j] * t);
      const vec2 off = p.Project(place, this->V.View) * half - at[i];
      const vec2 along = at[j] - at[i];
      const double beside = std::abs(along.x * off.y - along.y * off.x);
      if (!(BetweenQuarters * beside <= PlainError * glm::length(along)))
      {
        return false;
      }
    }
  }
  return true;
}
}
