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

// Of a direction, along the axis of a perspective: nearer to the plane of the eye it has no bound.
constexpr double LeastAhead = 0.02;

// Pixels by which a rasterizer snaps corners, and by which the place of a corner in float32 may
// err in a picture so many pixels wide (Agreement of GpuMathTest.cxx).
constexpr double Snap = 1.0 / 128;
constexpr double PlaceError = 0.02;
constexpr double PlaceErrorWidth = 8192;

// Sine of the angle under which a triangle is seen edge-on: chords may turn the side round.
constexpr double EdgeOn = 0.02;

// Radii of the circle where rays begin, and edges: so many the horizontal way to a triangle is at
// least. The bound of GetAside is of the second order there.
constexpr double LeastRadii = 2;
constexpr double LeastEdges = 4;

// Of a triangle's longest edge: so near its corners is all of it (1 / sqrt(3)).
constexpr double FromCorners = 0.578;

// Factor on what follows from the middle of a triangle, for its ends.
constexpr double BetweenCorners = 1.5;

// Radians: edges that are off their great circles by more are measured.
constexpr double LargestAside = 1e-3;
}

namespace wfv
{
bool SortView::IsSamePlace(const SortView& o) const
{
  const WfvView& a = this->View;
  const WfvView& b = o.View;
  return this->Map == o.Map && a.halfFov == b.halfFov && a.scale == b.scale && a.tilt == b.tilt &&
    a.radii == b.radii && a.lens == b.lens && a.lens5 == b.lens5 && a.maxAngle == b.maxAngle &&
    a.map == b.map && this->Own == o.Own && (!this->Own || a.stereo == b.stereo);
}

bool SortView::operator==(const SortView& o) const
{
  return this->IsSamePlace(o) && this->Part.Low == o.Part.Low && this->Part.High == o.Part.High &&
    this->Pixels == o.Pixels && this->Bends == o.Bends && this->Plain == o.Plain &&
    this->Calm == o.Calm && this->Rays == o.Rays && this->Folds == o.Folds &&
    this->Cheap == o.Cheap && this->Culls == o.Culls && this->Rounding == o.Rounding &&
    this->Samples == o.Samples && this->Reach == o.Reach && this->Tolerance == o.Tolerance &&
    this->Moving == o.Moving;
}

TriangleJudge::TriangleJudge(const SortView& view, int eye)
  : V(view)
  , Seen(view.GetViewOf(eye))
{
  const vec2 half = 0.5 * view.Pixels;
  this->Scale = half * half / 64.0; // of (a^2 / 8)^2, pixels
  this->Circle = view.Own ? std::abs(view.View.stereo.x) : 0;
  this->Pad = GetPad(view.Pixels);
}

bool TriangleJudge::MayTear(Family family, const vec3 d[3], double aside)
{
  const double beside = Beside + aside;
  if (family == Family::Meridian)
  {
    const double low = std::min({ d[0].x, d[1].x, d[2].x });
    const double high = std::max({ d[0].x, d[1].x, d[2].x });
    return low <= beside && high >= -beside && std::max({ d[0].z, d[1].z, d[2].z }) >= 0;
  }
  if (family == Family::Planar)
  {
    return std::max({ d[0].z, d[1].z, d[2].z }) > -LeastAhead;
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
    if (!(sign * d[i][axis] > others + beside))
    {
      return true;
    }
  }
  return false;
}

double TriangleJudge::Longest2(const vec3 p[3])
{
  const vec3 a = p[1] - p[0];
  const vec3 b = p[2] - p[1];
  const vec3 c = p[0] - p[2];
  return std::max({ glm::dot(a, a), glm::dot(b, b), glm::dot(c, c) });
}

bool TriangleJudge::IsBetweenSpheres(
  const WfvView& view, double nearest, double farthest, double angle2)
{
  return nearest > view.radii.x * (1 + angle2) && farthest < view.radii.y * (1 - 10 * Beside);
}

bool TriangleJudge::IsInDomain(const SortView& view, const vec3 d[3])
{
  if (view.Map->Axis != Family::Azimuthal)
  {
    return true;
  }
  const double rim = std::cos(view.View.maxAngle) + std::sqrt(Longest2(d));
  return -d[0].z >= rim && -d[1].z >= rim && -d[2].z >= rim;
}

double TriangleJudge::GetPad(const vec2& pixels)
{
  return Snap + PlaceError * std::max(pixels.x, pixels.y) / PlaceErrorWidth;
}

TriangleJudge::Corner TriangleJudge::See(const vec3& place) const
{
  Corner c;
  c.Place = place;
  c.Distance = std::sqrt(glm::dot(place, place));
  c.Direction = place / c.Distance;
  if (this->V.Own)
  {
    const WfvSight sight = this->V.Own->See(place, this->Seen);
    c.Distance = sight.seen ? sight.distance : std::numeric_limits<double>::quiet_NaN();
    c.Direction = sight.direction;
  }
  c.At = this->V.Samples.At(this->V.Map->Project(c.Direction, this->V.View));
  return c;
}

// From each corner another ray looks, by as much as the circle turns between them.
double TriangleJudge::GetAside(const Corner* const c[3]) const
{
  constexpr double unknown = std::numeric_limits<double>::infinity();
  const WfvView& v = this->V.View;
  const vec3 up(0, v.tilt.x, -v.tilt.y);
  double level = unknown;
  double nearest = unknown;
  double farthest = 0;
  for (int i = 0; i < 3; i++)
  {
    const double sine = glm::dot(c[i]->Direction, up);
    const double way = c[i]->Distance * std::sqrt(std::max(0.0, 1 - sine * sine));
    if (!(way > 0))
    {
      return unknown;
    }
    level = std::min(level, way);
    farthest = std::max(farthest, std::hypot(way, this->Circle)); // from its axis
    nearest = std::min(nearest, c[i]->Distance);
  }
  const vec3 places[3] = { c[0]->Place, c[1]->Place, c[2]->Place };
  const double edge = std::sqrt(Longest2(places));
  if (level > LeastRadii * this->Circle && LeastEdges * edge < level)
  {
    return this->Circle * Square(edge / level) / nearest;
  }
  // what all turn by is a turn of great circles
  const double inner = std::hypot(level, this->Circle) - FromCorners * edge;
  return inner - this->Circle >= edge
    ? std::asin(this->Circle / inner) - std::asin(this->Circle / farthest)
    : unknown;
}

int TriangleJudge::GetSide(const vec3& p, const vec3& q, const vec3& r) const
{
  const vec3 n = glm::cross(q - p, r - p);
  const double s = glm::dot(n, p);
  const double least = EdgeOn * glm::length(p) + this->Circle;
  const bool clear = s * s > least * least * glm::dot(n, n);
  return !clear ? 0 : s < 0 ? -1 : 1;
}

TriangleJudge::Verdict TriangleJudge::Judge(const Corner* const c[3]) const
{
  Verdict verdict;
  const vec3 d[3] = { c[0]->Direction, c[1]->Direction, c[2]->Direction };
  const double angle2 = Longest2(d);
  const vec2 sum = c[0]->At + c[1]->At + c[2]->At;
  const bool known = std::isfinite(sum.x + sum.y); // comparisons would pass over a corner
  const double aside = this->V.Own ? this->GetAside(c) : 0;
  if (!known || !(angle2 <= Square(2 * LongestMeasured)) || !std::isfinite(aside) ||
    MayTear(this->V.Map->Axis, d, aside))
  {
    return verdict;
  }
  const double nearest = std::min({ c[0]->Distance, c[1]->Distance, c[2]->Distance });
  const Local local = this->LookAt(d, angle2, aside);
  const bool tiny = angle2 <= Square(LocalBend::LongestEdge) && aside <= LargestAside;
  // seen by rays of its own a triangle may fold, where some of them see it edge-on: its inside is
  // then as far off as its edges are, else it is within them
  const bool folds = aside > 0 && this->GetSide(c[0]->Place, c[1]->Place, c[2]->Place) == 0;
  const double stretch = local.Stretch * (tiny ? 1 : BetweenCorners);
  const double moved = this->GetMoved(nearest, stretch) + (folds ? aside * stretch : 0);
  Bulge off[3];
  double worst = std::numeric_limits<double>::infinity();
  if (tiny)
  {
    worst = std::sqrt(local.Bound2);
    verdict.Empty = this->IsEmpty(c, worst + moved + this->Pad);
    for (int i = 0; i < 3; i++)
    {
      const vec3 edge = d[(i + 1) % 3] - d[i];
      off[i].Left = off[i].Right = angle2 > 0 ? worst * (glm::dot(edge, edge) / angle2) : 0;
    }
  }
  if (!verdict.Empty)
  {
    this->JudgeEdges(c, angle2, worst, moved, off, verdict);
  }
  return verdict;
}

// worst, off: pixels of the edges from their chords, so far as known.
void TriangleJudge::JudgeEdges(const Corner* const c[3], double angle2, double worst, double moved,
  Bulge off[3], Verdict& verdict) const
{
  if (this->V.Measures && worst > SortView::PlainError && this->Measure(c, angle2, off))
  {
    worst = std::max({ off[0].GetMost(), off[1].GetMost(), off[2].GetMost() });
  }
  const double sure = moved + this->Pad;
  // a side moves out by what its edge bulges and by what any edge reaches beyond its ends
  double sides = 0;
  double ends = 0;
  for (int i = 0; i < 3; i++)
  {
    sides = std::max({ sides, off[i].Left, off[i].Right });
    ends = std::max(ends, off[i].Ends);
  }
  verdict.Calm = this->V.Calm && angle2 > 0 && std::max(worst, sides + ends) + sure <= CalmError;
  verdict.Reach = verdict.Calm ? GetReach(c, off, sure) : 0;
  const double nearest = std::min({ c[0]->Distance, c[1]->Distance, c[2]->Distance });
  const double farthest = std::max({ c[0]->Distance, c[1]->Distance, c[2]->Distance });
  if (!this->V.Plain || !IsBetweenSpheres(this->V.View, nearest, farthest, Square(LongestPlain)))
  {
    return;
  }
  const vec3 d[3] = { c[0]->Direction, c[1]->Direction, c[2]->Direction };
  const bool folds = this->V.Map->FlatRim && !IsInDomain(this->V, d);
  verdict.Plain = worst <= std::max(SortView::PlainError, this->V.Moving) &&
    angle2 <= Square(LongestPlain) && !IsTurned(c) && !folds;
  verdict.Known = worst <= MostKnown && moved <= MostKnown;
  verdict.Sure = sure;
  for (int i = 0; i < 3; i++)
  {
    verdict.Widths[i] = off[i].GetMost() + sure;
  }
}

TriangleJudge::Local TriangleJudge::LookAt(const vec3 d[3], double angle2, double aside) const
{
  double x = 0;
  double y = 0;
  double stretch = 0;
  for (int i = 0; i < 3; i++)
  {
    const LocalBend::Cell& bend = this->V.Bends->At(d[i]);
    x = std::max(x, double(bend[0]));
    y = std::max(y, double(bend[1]));
    stretch = std::max(stretch, double(bend[2]));
  }
  Local local{ angle2 * angle2 * (x * x * this->Scale.x + y * y * this->Scale.y),
    0.5 * stretch * std::max(this->V.Pixels.x, this->V.Pixels.y) };
  if (aside > 0)
  {
    local.Bound2 = Square(std::sqrt(local.Bound2) + aside * local.Stretch);
  }
  return local;
}

// No sample is between the chords, nor as near to them as the edges and rounding reach.
bool TriangleJudge::IsEmpty(const Corner* const c[3], double reach) const
{
  const vec2 at[3] = { c[0]->At, c[1]->At, c[2]->At };
  return this->V.Samples.Misses(at, reach);
}

// Seen from the other side by its chords than by its edges.
bool TriangleJudge::IsTurned(const Corner* const c[3]) const
{
  const vec2 a = c[1]->At - c[0]->At;
  const vec2 b = c[2]->At - c[0]->At;
  return (a.x * b.y - a.y * b.x) * GetSide(c[0]->Place, c[1]->Place, c[2]->Place) > 0;
}

// The bound of a cell of directions is coarse near poles, and knows no directions of edges. False
// where the quarters of the edges say too little.
bool TriangleJudge::Measure(const Corner* const c[3], double angle2, Bulge off[3]) const
{
  const vec3 d[3] = { c[0]->Direction, c[1]->Direction, c[2]->Direction };
  if (!IsInDomain(this->V, d))
  {
    return false;
  }
  for (int i = 0; i < 3; i++)
  {
    const double sine = SineToSingularity(this->V.Map->Axis, d[i]);
    if (!(angle2 <= Square(2 * PartOfSine * sine)))
    {
      return false;
    }
  }
  Bulge measured[3];
  for (int i = 0; i < 3; i++)
  {
    measured[i] = this->MeasureEdge(*c[i], *c[(i + 1) % 3], CalmError);
    if (!(measured[i].GetMost() < CalmError))
    {
      return false;
    }
  }
  std::copy_n(measured, 3, off);
  return true;
}

bool TriangleJudge::MayTearBetween(const Corner& a, const Corner& b) const
{
  const vec3 d[3] = { a.Direction, b.Direction, b.Direction };
  return MayTear(this->V.Map->Axis, d, 0);
}

double TriangleJudge::GetMoved(double nearest, double stretch) const
{
  const double rounding = this->V.Own ? BetweenCorners * this->V.Rounding : this->V.Rounding;
  return rounding > 0 ? rounding / nearest * stretch : 0;
}
}
