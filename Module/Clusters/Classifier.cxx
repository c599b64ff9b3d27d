// SPDX-License-Identifier: BSD-3-Clause
#include "Clusters/Classifier.h"

#include <algorithm>
#include <cmath>

namespace wfv
{
namespace
{
// Relative to the distance: so near a discontinuity float32 may place a point beyond it.
constexpr double Beside = 1e-5;

// Cosine of the angle from the axis of a perspective: nearer to the plane of the eye no chord has
// a bound.
constexpr double LeastAhead = 0.02;

constexpr double Longer2 = ChordLimits::MostLonger * ChordLimits::MostLonger;

// How many times its nearest distance a triangle of several chords is long at the most; and up to
// which an edge comes nearer than its ends by an eighth of the square of that.
constexpr double LongestSplit = 4;
constexpr double LongestEven = 1;

// Of more chords it is asked whether they are long enough in the picture.
constexpr int ManyChords = 16;

// Nor is one tried after the other: so many chords more are a share of those that did not do.
constexpr int MoreChords = 4;

// Squared, from the eye to the nearest place of the edge p, q.
double EdgeDistance2(const vec3& p, const vec3& q)
{
  const vec3 way = q - p;
  const double share = std::clamp(-glm::dot(p, way) / glm::dot(way, way), 0.0, 1.0);
  const vec3 at = p + share * way;
  return glm::dot(at, at);
}

// The squared lengths of the edges, by the corner opposite.
vec3 Lengths2(const vec3 p[3])
{
  const vec3 edges[3] = { p[2] - p[1], p[0] - p[2], p[1] - p[0] };
  return vec3(
    glm::dot(edges[0], edges[0]), glm::dot(edges[1], edges[1]), glm::dot(edges[2], edges[2]));
}
}

bool ClassifierView::operator==(const ClassifierView& o) const
{
  const WfvView& a = this->View;
  const WfvView& b = o.View;
  return this->Map == o.Map && a.halfFov == b.halfFov && a.scale == b.scale && a.tilt == b.tilt &&
    a.radii == b.radii && a.lens == b.lens && a.lens5 == b.lens5 && a.lensHigh == b.lensHigh &&
    a.maxAngle == b.maxAngle && a.map == b.map && this->Part.Low == o.Part.Low &&
    this->Part.High == o.Part.High && this->Limits == o.Limits && this->Stereo == o.Stereo &&
    this->Culls == o.Culls && this->EyeRadius == o.EyeRadius &&
    this->BaselineRadius == o.BaselineRadius;
}

Classifier::Classifier(const ClassifierView& view)
  : V(view)
  , Axis(view.Map->Axis)
  , Circle(view.View, view.Stereo, view.EyeRadius, view.Limits.get(), view.Tolerance)
{
  constexpr double dip = 1 + ChordLimits::LongestChord * ChordLimits::LongestChord;
  const double inner = std::max(view.View.radii.x * dip, EyeCircle::LeastRadii * view.EyeRadius);
  const double outer = view.View.radii.y * (1 - 10 * Beside);
  this->Inner2 = inner * inner;
  this->Outer2 = outer * outer;
  this->RimCosine = std::cos(view.View.maxAngle);
  this->AllAround = view.Culls && ShowsAll(*view.Map, view.View, view.Part);
  this->RimAngle = view.Limits ? view.Limits->GetRimAngle() : 0;
}

// Unless all corners are well on one face of the cube round the eye.
bool Classifier::IsOnOneFace(const vec3 p[3], double beside) const
{
  const vec3 a = glm::abs(p[0]);
  const int axis = a.x >= a.y && a.x >= a.z ? 0 : a.y >= a.z ? 1 : 2;
  const double sign = p[0][axis] < 0 ? -1 : 1;
  bool one = true;
  for (int i = 0; i < 3; i++)
  {
    const double others = std::max(std::abs(p[i][(axis + 1) % 3]), std::abs(p[i][(axis + 2) % 3]));
    one = one && sign * p[i][axis] > others + beside;
  }
  return one;
}

// Whether a triangle may meet a discontinuity of the map, or reach beyond its rim. angle: of its
// longest edge, radians, at least.
bool Classifier::MayTear(const vec3 p[3], double farthest, double angle) const
{
  const double rounded = farthest * (Beside + this->RimAngle);
  const double beside = rounded + this->V.EyeRadius;
  switch (this->Axis)
  {
    case Family::Meridian:
      return IsAtSeam(p, beside) &&
        (!this->HasCircle() || this->Circle.MaySeeAtSeam(p, angle * farthest, rounded));
    case Family::Planar:
      return std::max({ p[0].z, p[1].z, p[2].z }) > -LeastAhead * farthest - beside;
    case Family::Faces:
      return !this->IsOnOneFace(p, 2 * beside); // it changes by no more along any two axes
    case Family::Azimuthal:
    {
      const double rim = this->RimCosine + angle;
      for (int i = 0; i < 3; i++)
      {
        if (!(-p[i].z - beside >= rim * glm::length(p[i])))
        {
          return true;
        }
      }
      return false;
    }
    default:
      return true;
  }
}

bool Classifier::SphereMayTear(const vec3& c, double radius, double angle) const
{
  const double distance = glm::length(c);
  const double beside =
    (distance + radius) * (Beside + this->RimAngle) + this->V.EyeRadius + radius;
  switch (this->Axis)
  {
    case Family::Meridian:
      return std::abs(c.x) <= beside && c.z >= -beside;
    case Family::Planar:
      return c.z + beside > -LeastAhead * (distance + radius);
    case Family::Faces:
    {
      const vec3 same[3] = { c, c, c };
      return !this->IsOnOneFace(same, 2 * beside);
    }
    case Family::Azimuthal:
      return !(-c.z - beside >= (this->RimCosine + angle) * (distance + radius) &&
        -c.z - beside >= (this->RimCosine + angle) * std::max(0.0, distance - radius));
    default:
      return true;
  }
}

double Classifier::LimitAt(const vec3& p) const
{
  return this->HasCircle() ? this->Circle.LimitAt(p) : this->V.Limits->At(p);
}

// Whether a chord stands for a part of an edge.
bool Classifier::IsChord(const vec3& p, const vec3& q, double limit2, bool sampled) const
{
  if (this->HasCircle() && sampled)
  {
    return this->Circle.HasChord(p, q, limit2);
  }
  const vec3 way = q - p;
  const double length2 = glm::dot(way, way);
  if (length2 <= limit2)
  {
    return !this->HasCircle() || this->Circle.IsShort(p, length2, limit2);
  }
  return sampled && length2 <= Longer2 * limit2 && this->V.Limits->IsNearChord(p, q);
}

// Seen from the eye no part of an edge looks longer than it would at its nearer end. sampled: parts
// that are longer than the bound for all directions says are looked at.
bool Classifier::FitChords(const vec3& p, const vec3& q, int chords, bool sampled) const
{
  const vec3 step = (q - p) / double(chords);
  // of equal ones the farthest looks shortest
  if (chords > ManyChords &&
    !(this->V.Limits->IsLongEnough(p, p + step) && this->V.Limits->IsLongEnough(q - step, q)))
  {
    return false;
  }
  double before = this->LimitAt(p) * glm::dot(p, p);
  vec3 last = p;
  for (int i = 1; i <= chords; i++)
  {
    const vec3 at = i < chords ? p + double(i) * step : q;
    const double here = this->LimitAt(at) * glm::dot(at, at);
    const double limit2 = std::min(before, here);
    if (!this->IsChord(last, at, limit2, sampled))
    {
      return false;
    }
    before = here;
    last = at;
  }
  return true;
}

// limit2: the squared length of a chord at the shorter of its ends, at the most.
int Classifier::ChordsOf(const vec3& p, const vec3& q, double limit2) const
{
  const vec3 way = q - p;
  const double length2 = glm::dot(way, way);
  if (length2 <= limit2 && !this->HasCircle())
  {
    return 1;
  }
  if (!(length2 <= MostChords * MostChords * Longer2 * limit2))
  {
    return 0;
  }
  // from the same end for both triangles, or they were rounded apart
  const bool ordered = p.x != q.x ? p.x < q.x : p.y != q.y ? p.y < q.y : p.z < q.z;
  const vec3& from = ordered ? p : q;
  const vec3& to = ordered ? q : p;
  if (this->IsChord(from, to, limit2, true))
  {
    return 1;
  }
  return this->SeveralChordsOf(from, to, length2 / limit2);
}

// times2: how many times longer the edge is than a chord by the bound for all directions, squared.
int Classifier::SeveralChordsOf(const vec3& from, const vec3& to, double times2) const
{
  const int least = std::max(1, static_cast<int>(std::ceil(std::sqrt(times2))));
  const int few = std::clamp((least + 1) / 2, 2, MostChords); // enough of most edges
  if (this->FitChords(from, to, few, true))
  {
    return few;
  }
  for (int chords = least; chords <= MostChords; chords += 1 + chords / MoreChords)
  {
    if (this->FitChords(from, to, chords, false))
    {
      return chords;
    }
  }
  return few < MostChords && this->FitChords(from, to, MostChords, true) ? MostChords : 0;
}

// Whether a triangle stays outside the near sphere. Of a long one each place is nearer to a long
// edge than the shortest one is long.
bool Classifier::IsFarEnough(const vec3 p[3], double nearest2, double angle2) const
{
  if (angle2 <= LongestEven * LongestEven)
  {
    return nearest2 > (1 + 0.5 * angle2) * this->Inner2;
  }
  const double edges2 =
    std::min({ EdgeDistance2(p[0], p[1]), EdgeDistance2(p[1], p[2]), EdgeDistance2(p[2], p[0]) });
  const vec3 lengths2 = Lengths2(p);
  const double shortest2 = std::min({ lengths2.x, lengths2.y, lengths2.z });
  return std::sqrt(edges2) - std::sqrt(shortest2) > std::sqrt(this->Inner2);
}

// Whether nothing speaks against it but how long the edges are.
bool Classifier::MayProject(const vec3 p[3]) const
{
  const double away2[3] = { glm::dot(p[0], p[0]), glm::dot(p[1], p[1]), glm::dot(p[2], p[2]) };
  const double nearest2 = std::min({ away2[0], away2[1], away2[2] });
  const double farthest2 = std::max({ away2[0], away2[1], away2[2] });
  const vec3 lengths2 = Lengths2(p);
  const double angle2 = std::max({ lengths2.x, lengths2.y, lengths2.z }) / nearest2;
  return farthest2 < this->Outer2 && angle2 <= LongestSplit * LongestSplit &&
    this->IsFarEnough(p, nearest2, angle2) &&
    !this->MayTear(p, std::sqrt(farthest2), std::sqrt(angle2));
}

// No chord stands for an edge that meets a discontinuity; all triangles at it are ray-tested.
void Classifier::LeaveDiscontinuousEdges(const vec3 p[3], Triangle& t) const
{
  for (int i = 0; i < 3; i++)
  {
    const vec3 edge[3] = { p[(i + 1) % 3], p[(i + 2) % 3], p[(i + 2) % 3] };
    const double away2[2] = { glm::dot(edge[0], edge[0]), glm::dot(edge[1], edge[1]) };
    const vec3 way = edge[1] - edge[0];
    const double angle = std::sqrt(glm::dot(way, way) / std::min(away2[0], away2[1]));
    if (this->MayTear(edge, std::sqrt(std::max(away2[0], away2[1])), angle))
    {
      t.Chords[i] = 0;
    }
  }
}

Classifier::Triangle Classifier::OfTriangle(const vec3& a, const vec3& b, const vec3& c) const
{
  const vec3 p[3] = { a, b, c };
  double limit2[3];
  for (int i = 0; i < 3; i++)
  {
    limit2[i] = this->LimitAt(p[i]) * glm::dot(p[i], p[i]);
  }
  Triangle t;
  for (int i = 0; i < 3; i++)
  {
    const int j = (i + 1) % 3;
    const int k = (i + 2) % 3;
    t.Chords[i] = this->ChordsOf(p[j], p[k], std::min(limit2[j], limit2[k]));
  }
  const int most = std::max({ t.Chords[0], t.Chords[1], t.Chords[2] });
  const int least = std::min({ t.Chords[0], t.Chords[1], t.Chords[2] });
  if (least == 0 || (most > MostRows && least > 1) || !this->MayProject(p))
  {
    this->LeaveDiscontinuousEdges(p, t);
    return t;
  }
  t.Class = most == 1 ? DrawClass::Projected : DrawClass::Cut;
  return t;
}

bool Classifier::HasChordsAround(const vec3& centre, double radius, double edge, int chords) const
{
  const double distance = glm::length(centre);
  const double nearest = distance - radius;
  const double part = edge / chords;
  const double limit = this->HasCircle() ? this->Circle.LimitAround(centre, radius, part)
                                         : this->V.Limits->LeastAround(centre, radius / distance);
  return !this->V.Limits->IsBesideSingularity(centre, radius / distance) &&
    part * part <= limit * nearest * nearest &&
    !this->SphereMayTear(centre, radius, chords * ChordLimits::LongestChord);
}

int Classifier::ChordsOfAll(const Box& box, double radius, double edge, int most) const
{
  Box seen = box;
  seen.Grow(this->V.BaselineRadius);
  if (this->V.Culls &&
    (this->AllAround ? !IsBetweenClips(this->V.View, seen)
                     : IsCulled(*this->V.Map, this->V.View, seen, this->V.Part)))
  {
    return Unseen;
  }
  const vec3 centre = 0.5 * (box.Low + box.High);
  const double distance = glm::length(centre);
  const double nearest = distance - radius;
  const double farthest = distance + radius;
  if (!this->V.Limits ||
    !(nearest > 0 && nearest * nearest > this->Inner2 && farthest * farthest < this->Outer2))
  {
    return None;
  }
  int chords = 1;
  while (chords <= most && !this->HasChordsAround(centre, radius, edge, chords))
  {
    chords *= 2;
  }
  return chords <= most ? chords : None;
}

DrawClass Classifier::OfCluster(const Box& box, double radius, double edge) const
{
  const int chords = this->ChordsOfAll(box, radius, edge, 1);
  if (chords == None)
  {
    return this->V.Limits ? DrawClass::Mixed : DrawClass::RayTested;
  }
  return chords == Unseen ? DrawClass::Culled : DrawClass::Projected;
}
}
