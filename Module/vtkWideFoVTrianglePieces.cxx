// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWideFoVTrianglePieces.h"

#include "Projections/Bend.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace
{
using namespace wfv;

// Places of an arc that are looked at, ends included; those that its bend is first judged by.
constexpr int Places = 5;
constexpr int FirstPlaces = 9;

// Pixels that the edges of a slab may be off their chords, more or less, and slabs of a triangle.
constexpr double SlabError = 0.15;
constexpr int MostSlabs = 16;

// Square pixels that a shape more costs about as much as.
constexpr double ShapeCost = 32;

// Of the rays' lengths, so small a product of three is rounding.
constexpr double Flat = 1e-12;

vec3 Between(const vec3& a, const vec3& b, double t)
{
  return glm::normalize(a * (1 - t) + b * t);
}

double Cross(const vec2& a, const vec2& b)
{
  return a.x * b.y - a.y * b.x;
}

// True where a point on the sphere is surely not in a triangle.
bool IsOutside(const vec3 d[3], const vec3& point)
{
  double low = 0;
  double high = 0;
  for (int i = 0; i < 3; i++)
  {
    const double side = glm::dot(glm::cross(d[i], d[(i + 1) % 3]), point);
    low = std::min(low, side);
    high = std::max(high, side);
  }
  return low < -Flat && high > Flat;
}
}

namespace wfv
{
// What was seen of the boundary of a slab.
struct TrianglePieces::Boundary
{
  std::array<vec2, 4 * Places> Seen;
  int Count = 0;
  double Off = 0;     // pixels, of its arcs from their chords
  double Stretch = 0; // pixels a radian
};

// Between two arcs across a triangle, from Low and High at one end to those at the other.
struct TrianglePieces::Slab
{
  vec3 Low[2];
  vec3 High[2];
};

TrianglePieces::TrianglePieces(const SortView& view)
  : V(view)
  , Middle(0.5 * view.Samples.GetSize())
  , Pad(TriangleJudge::GetPad(view.Pixels))
{
}

vec2 TrianglePieces::PlaceOf(const vec3& direction) const
{
  return this->V.Samples.At(this->V.Map->Project(direction, this->V.View));
}

// No tear, no pole, and not at the rim of the map.
bool TrianglePieces::IsWhole(const vec3 d[3]) const
{
  const Family family = this->V.Map->Axis;
  if (TriangleJudge::MayTear(family, d, 0) || !TriangleJudge::IsInDomain(this->V, d))
  {
    return false;
  }
  if (family == Family::Meridian)
  {
    return IsOutside(d, vec3(0, 1, 0)) && IsOutside(d, vec3(0, -1, 0));
  }
  return family != Family::Azimuthal || IsOutside(d, vec3(0, 0, 1));
}

// Pixels that an arc is about off its chord.
double TrianglePieces::Measure(const vec3& from, const vec3& to) const
{
  const vec2 first = this->PlaceOf(from);
  const vec2 way = this->PlaceOf(to) - first;
  const double length = std::max(glm::length(way), 1e-9);
  double off = 0;
  for (int i = 1; i < FirstPlaces - 1; i++)
  {
    const vec2 at = this->PlaceOf(Between(from, to, double(i) / (FirstPlaces - 1)));
    off = std::max(off, std::abs(Cross(way, at - first)) / length);
  }
  return off;
}

// False where its places say too little.
bool TrianglePieces::Look(const vec3& from, const vec3& to, Boundary& b) const
{
  const Family family = this->V.Map->Axis;
  const double sine = std::min(SineToSingularity(family, from), SineToSingularity(family, to));
  const double longest = TriangleJudge::PartOfSine * std::min(1.0, sine);
  const vec3 chord = to - from;
  if (!(glm::dot(chord, chord) <= longest * longest))
  {
    return false;
  }
  vec2* const seen = b.Seen.data() + b.Count;
  for (int i = 0; i < Places; i++)
  {
    const vec3 direction = Between(from, to, double(i) / (Places - 1));
    seen[i] = this->PlaceOf(direction);
    if (this->V.Rounding > 0)
    {
      b.Stretch = std::max(b.Stretch, double(this->V.Bends->At(direction)[2]));
    }
  }
  b.Count += Places;
  const vec2 way = seen[Places - 1] - seen[0];
  const double length = glm::length(way);
  for (int i = 1; i < Places - 1; i++)
  {
    const vec2 at = seen[i] - seen[0];
    b.Off = std::max(b.Off, length > 0 ? std::abs(Cross(way, at)) / length : glm::length(at));
  }
  return std::isfinite(b.Off);
}

bool TrianglePieces::Enclose(const Slab& slab, double nearest, CoverPiece& piece) const
{
  Boundary b;
  if (!this->Look(slab.Low[0], slab.Low[1], b) || !this->Look(slab.High[0], slab.High[1], b) ||
    !this->Look(slab.Low[0], slab.High[0], b) || !this->Look(slab.Low[1], slab.High[1], b))
  {
    return false;
  }
  const vec2 way = b.Seen[Places - 1] - b.Seen[0] + b.Seen[2 * Places - 1] - b.Seen[Places];
  const double length = glm::length(way);
  const vec2 along = length > 0 ? way / length : vec2(1, 0);
  vec2 low(std::numeric_limits<double>::infinity());
  vec2 high = -low;
  for (const vec2& seen : b.Seen)
  {
    const vec2 at = seen - this->Middle;
    const vec2 turned(glm::dot(along, at), Cross(along, at));
    low = glm::min(low, turned);
    high = glm::max(high, turned);
  }
  const double pixels = 0.5 * std::max(this->V.Pixels.x, this->V.Pixels.y);
  const double moved = this->V.Rounding > 0 ? this->V.Rounding / nearest * b.Stretch * pixels : 0;
  const double grow = (TriangleJudge::BetweenParts - 1) * b.Off + moved + this->Pad;
  low -= grow;
  high += grow;
  const vec2 up(-along.y, along.x);
  piece.From = along * low.x + up * low.y;
  piece.Side = along * (high.x - low.x);
  piece.Height = high.y - low.y;
  return std::isfinite(grow + piece.Height + glm::dot(piece.From, piece.Side));
}

bool TrianglePieces::Cover(unsigned int triangle, const TriangleJudge::Corner* const corners[3],
  double most, std::vector<CoverPiece>& pieces) const
{
  vec3 d[3];
  double sides[3];
  for (int i = 0; i < 3; i++)
  {
    d[i] = corners[i]->Direction;
    sides[i] = glm::length(corners[(i + 1) % 3]->At - corners[i]->At);
  }
  if (!this->IsWhole(d))
  {
    return false;
  }
  const auto longest = static_cast<int>(std::max_element(sides, sides + 3) - sides);
  const vec3& p = d[longest];
  const vec3& q = d[(longest + 1) % 3];
  const vec3& r = d[(longest + 2) % 3];
  const double off = std::max({ this->Measure(p, q), this->Measure(q, r), this->Measure(r, p) });
  const double nearest =
    std::min({ corners[0]->Distance, corners[1]->Distance, corners[2]->Distance });
  const std::size_t before = pieces.size();
  const int first = std::clamp(int(std::ceil(std::sqrt(off / SlabError))), 2, MostSlabs);
  for (int n = first; n <= MostSlabs; n *= 2)
  {
    if (this->Cut({ p, q, r }, n, triangle, nearest, most, pieces))
    {
      return true;
    }
    pieces.resize(before);
  }
  return false;
}

bool TrianglePieces::Cut(const std::array<vec3, 3>& d, int slabs, unsigned int triangle,
  double nearest, double most, std::vector<CoverPiece>& pieces) const
{
  const double first = glm::length(d[2] - d[0]);
  const double apex = first / (first + glm::length(d[1] - d[2]));
  const int before = std::clamp(int(std::round(slabs * apex)), 1, slabs - 1);
  Slab slab{ { d[0], d[0] }, { d[0], d[0] } };
  double area = 0;
  for (int i = 1; i <= slabs; i++)
  {
    const bool left = i <= before;
    const double t = left ? double(i) / before : double(i - before) / (slabs - before);
    slab.Low[0] = slab.Low[1];
    slab.High[0] = slab.High[1];
    slab.Low[1] = Between(d[0], d[1], left ? t * apex : apex + t * (1 - apex));
    slab.High[1] = left ? Between(d[0], d[2], t) : Between(d[2], d[1], t);
    CoverPiece piece;
    piece.Triangle = triangle;
    if (!this->Enclose(slab, nearest, piece))
    {
      return false;
    }
    area += glm::length(piece.Side) * piece.Height + ShapeCost;
    if (!(area <= most))
    {
      return false;
    }
    pieces.push_back(piece);
  }
  return true;
}
}
