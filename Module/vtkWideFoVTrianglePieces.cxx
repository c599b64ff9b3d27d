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
constexpr int MostSlabs = 64;

// Square pixels that a shape more costs about as much as.
constexpr double ShapeCost = 32;

// Of the level way from the circle where rays of their own begin: slabs whose places say enough.
constexpr double PartOfWay = 0.5;

// Of the rays' lengths, so small a product of three is rounding.
constexpr double Flat = 1e-12;

// On what parabolas through places say of an arc between them: as much as BetweenParts has over
// what they say of one that bends to one side.
constexpr double BeyondParts = 3.2;

double Cross(const vec2& a, const vec2& b)
{
  return a.x * b.y - a.y * b.x;
}

// By how much a curve may reach beyond its places, by a parabola through three of them: between two
// with this difference, where second differences are as large as that.
double BeyondStep(double difference, double second)
{
  const double rest = 0.5 * std::abs(second) - std::abs(difference);
  return rest > 0 ? rest * rest / (2 * std::abs(second)) : 0;
}

// The same of an arc, along this direction or across it.
double BeyondPlaces(const vec2* seen, const vec2& along)
{
  double beyond = 0;
  for (int i = 1; i < Places - 1; i++)
  {
    const vec2 before = seen[i] - seen[i - 1];
    const vec2 behind = seen[i + 1] - seen[i];
    for (const vec2& step : { before, behind })
    {
      beyond =
        std::max({ beyond, BeyondStep(glm::dot(along, step), glm::dot(along, behind - before)),
          BeyondStep(Cross(along, step), Cross(along, behind - before)) });
    }
  }
  return beyond;
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

TrianglePieces::TrianglePieces(const SortView& view, int eye)
  : V(view)
  , Judge(view, eye)
  , Middle(0.5 * view.Samples.GetSize())
  , Pad(TriangleJudge::GetPad(view.Pixels))
{
  if (view.GetNumberOfEyes() > 1)
  {
    this->Eye = view.GetViewOf(eye).stereo.x < 0 ? -1 : 1;
  }
  const Projection& map = *view.Map;
  if (view.Own && map.Axis == Family::Meridian && map.StraightSeam)
  {
    this->Round = map.Map(vec2(WFV_PI, 0), view.View).x * view.Pixels.x;
  }
}

// On the same side of a straight seam, which a triangle may cross.
vec2 TrianglePieces::Unroll(vec2 at, const vec2& beside) const
{
  if (this->Round > 0)
  {
    at.x -= this->Round * std::round((at.x - beside.x) / this->Round);
  }
  return at;
}

vec3 TrianglePieces::Between(const vec3& a, const vec3& b, double t) const
{
  const vec3 place = a * (1 - t) + b * t;
  return this->V.Own ? place : glm::normalize(place);
}

vec2 TrianglePieces::PlaceOf(const vec3& place) const
{
  return this->V.Own ? this->Judge.See(place).At
                     : this->V.Samples.At(this->V.Map->Project(place, this->V.View));
}

vec3 TrianglePieces::DirectionOf(const vec3& place) const
{
  return this->V.Own ? this->Judge.See(place).Direction : place;
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
  const vec2 way = this->Unroll(this->PlaceOf(to), first) - first;
  const double length = std::max(glm::length(way), 1e-9);
  double off = 0;
  for (int i = 1; i < FirstPlaces - 1; i++)
  {
    const double t = double(i) / (FirstPlaces - 1);
    const vec2 at = this->Unroll(this->PlaceOf(this->Between(from, to, t)), first);
    off = std::max(off, std::abs(Cross(way, at - first)) / length);
  }
  return off;
}

// False where its places say too little.
bool TrianglePieces::Look(const vec3& from, const vec3& to, Boundary& b) const
{
  const Family family = this->V.Map->Axis;
  const vec3 ends[2] = { this->DirectionOf(from), this->DirectionOf(to) };
  const double sine =
    std::min(SineToSingularity(family, ends[0]), SineToSingularity(family, ends[1]));
  const double longest = TriangleJudge::PartOfSine * std::min(1.0, sine);
  const vec3 chord = ends[1] - ends[0];
  if (!(glm::dot(chord, chord) <= longest * longest))
  {
    return false;
  }
  vec2* const seen = b.Seen.data() + b.Count;
  for (int i = 0; i < Places; i++)
  {
    const vec3 place = this->Between(from, to, double(i) / (Places - 1));
    seen[i] = this->PlaceOf(place);
    seen[i] = this->Unroll(seen[i], b.Seen[0]);
    if (this->V.Rounding > 0)
    {
      b.Stretch = std::max(b.Stretch, double(this->V.Bends->At(this->DirectionOf(place))[2]));
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

// Radians that the edges of a slab, seen by rays of its own, may be off great circles; infinite
// where it is as near to the circle where rays begin as it is wide.
double TrianglePieces::GetTurn(const Slab& slab) const
{
  const WfvView& v = this->V.View;
  const vec3 up(0, v.tilt.x, -v.tilt.y);
  const vec3 places[4] = { slab.Low[0], slab.Low[1], slab.High[1], slab.High[0] };
  double way2 = std::numeric_limits<double>::infinity();
  double edge2 = 0;
  for (int i = 0; i < 4; i++)
  {
    const vec3& p = places[i];
    const vec3 side = places[(i + 1) % 4] - p;
    const vec3 across = places[(i + 2) % 4] - p;
    const double height = glm::dot(p, up);
    way2 = std::min(way2, glm::dot(p, p) - height * height);
    edge2 = std::max({ edge2, glm::dot(side, side), glm::dot(across, across) });
  }
  const double part = std::sqrt(edge2) / (std::sqrt(way2) - std::abs(v.stereo.x));
  return part > 0 && part < PartOfWay ? 0.5 * part * part : std::numeric_limits<double>::infinity();
}

// Whether a slab is seen by rays of its own as it has to be: at most a straight seam goes through
// it. One whose arcs are short holds no pole.
bool TrianglePieces::IsWhole(const Slab& slab, bool& torn) const
{
  const vec3 seen[4] = { this->DirectionOf(slab.Low[0]), this->DirectionOf(slab.Low[1]),
    this->DirectionOf(slab.High[0]), this->DirectionOf(slab.High[1]) };
  const double turn = this->GetTurn(slab);
  const Family family = this->V.Map->Axis;
  torn =
    TriangleJudge::MayTear(family, seen, turn) || TriangleJudge::MayTear(family, seen + 1, turn);
  return std::isfinite(turn) && (!torn || this->Round > 0) &&
    TriangleJudge::IsInDomain(this->V, seen) && TriangleJudge::IsInDomain(this->V, seen + 1);
}

// Pixels by which what a boundary holds may be outside its places, along this direction or across.
double TrianglePieces::GetBeyond(const Boundary& b, const vec2& along) const
{
  // seen by rays of its own it may fold, and what is within bulges as its edges do
  const double parts =
    this->V.Own ? 2 * TriangleJudge::BetweenParts - 1 : TriangleJudge::BetweenParts - 1;
  double beyond = 0;
  for (int i = 0; i < b.Count; i += Places)
  {
    beyond = std::max(beyond, BeyondPlaces(&b.Seen[static_cast<std::size_t>(i)], along));
  }
  return std::max(parts * b.Off, BeyondParts * beyond);
}

bool TrianglePieces::Enclose(const Slab& slab, double moved, CoverPiece& piece, bool& torn) const
{
  Boundary b;
  torn = false;
  if ((this->V.Own && !this->IsWhole(slab, torn)) || !this->Look(slab.Low[0], slab.Low[1], b) ||
    !this->Look(slab.High[0], slab.High[1], b) || !this->Look(slab.Low[0], slab.High[0], b) ||
    !this->Look(slab.Low[1], slab.High[1], b))
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
  const double shift = moved > 0 ? moved * b.Stretch * pixels : 0;
  const double grow = this->GetBeyond(b, along) + shift + this->Pad;
  low -= grow;
  high += grow;
  const vec2 up(-along.y, along.x);
  piece.Eye = this->Eye;
  piece.From = along * low.x + up * low.y;
  piece.Side = along * (high.x - low.x);
  piece.Height = high.y - low.y;
  return std::isfinite(grow + piece.Height + glm::dot(piece.From, piece.Side));
}

bool TrianglePieces::Cover(unsigned int triangle, const TriangleJudge::Corner* const corners[3],
  double most, std::vector<CoverPiece>& pieces) const
{
  vec3 d[3];
  vec3 ends[3];
  double sides[3];
  for (int i = 0; i < 3; i++)
  {
    d[i] = corners[i]->Direction;
    ends[i] = this->V.Own ? corners[i]->Place : d[i];
    const vec2& at = corners[i]->At;
    sides[i] = glm::length(this->Unroll(corners[(i + 1) % 3]->At, at) - at);
  }
  // seen by rays of its own each slab is asked; one whose arcs are short holds no pole
  if (!this->V.Own && !this->IsWhole(d))
  {
    return false;
  }
  const auto longest = static_cast<int>(std::max_element(sides, sides + 3) - sides);
  const vec3& p = ends[longest];
  const vec3& q = ends[(longest + 1) % 3];
  const vec3& r = ends[(longest + 2) % 3];
  const double off = std::max({ this->Measure(p, q), this->Measure(q, r), this->Measure(r, p) });
  const double nearest =
    std::min({ corners[0]->Distance, corners[1]->Distance, corners[2]->Distance });
  const double moved = this->Judge.GetMoved(nearest, 1);
  const std::size_t before = pieces.size();
  const int first = std::clamp(int(std::ceil(std::sqrt(off / SlabError))), 2, MostSlabs);
  for (int n = first; n <= MostSlabs; n *= 2)
  {
    if (this->Cut({ p, q, r }, n, triangle, moved, most, pieces))
    {
      return true;
    }
    pieces.resize(before);
  }
  return false;
}

bool TrianglePieces::Cut(const std::array<vec3, 3>& d, int slabs, unsigned int triangle,
  double moved, double most, std::vector<CoverPiece>& pieces) const
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
    slab.Low[1] = this->Between(d[0], d[1], left ? t * apex : apex + t * (1 - apex));
    slab.High[1] = left ? this->Between(d[0], d[2], t) : this->Between(d[2], d[1], t);
    CoverPiece piece;
    piece.Triangle = triangle;
    bool torn;
    if (!this->Enclose(slab, moved, piece, torn))
    {
      return false;
    }
    area += glm::length(piece.Side) * piece.Height + ShapeCost;
    if (!(area <= most))
    {
      return false;
    }
    this->Append(piece, torn, pieces);
  }
  return true;
}

// torn: by a straight seam, on both sides of which it may be.
void TrianglePieces::Append(CoverPiece piece, bool torn, std::vector<CoverPiece>& pieces) const
{
  if (!torn)
  {
    pieces.push_back(piece);
    return;
  }
  const double x = piece.From.x;
  for (const double turn : { -this->Round, 0.0, this->Round })
  {
    piece.From.x = x + turn;
    if (this->IsInPicture(piece))
    {
      pieces.push_back(piece);
    }
  }
}

// Across, at least.
bool TrianglePieces::IsInPicture(const CoverPiece& piece) const
{
  const double up = -piece.Side.y * (piece.Height / glm::length(piece.Side));
  const auto range = std::minmax({ piece.From.x, piece.From.x + piece.Side.x, piece.From.x + up,
    piece.From.x + piece.Side.x + up });
  return range.second >= -this->Middle.x && range.first <= this->Middle.x;
}
}
