// SPDX-License-Identifier: BSD-3-Clause
// Directions beside the ray are d + s a + t b, with s and t from -1 to 1. There the edges of
// triangles are straight lines, and so is where one triangle comes before another: what of the
// cell can be seen is a set of convex polygons. A point inside one is looked at; what hides the
// cell there is taken away, and so on.
#include "Witness.h"

#include "RayTriangle.h"
#include "RightAnswers.h"

#include <algorithm>
#include <cmath>

namespace wfv
{
namespace reference
{
namespace
{
// Looks: more than any ray of the tests needs; past it a cell counts as not seen.
constexpr int MostLooks = 2000;

// Times what an edge function changes by over AnswerAngle, for the choice in double of what is
// looked at in rational numbers.
constexpr double ChoiceSafety = 4;

using Place = std::array<Rational, 2>; // s, t
using Outline = std::vector<Place>;    // convex

struct Line // positive or 0 on one side: At + S s + T t
{
  Rational At;
  Rational S;
  Rational T;

  Rational Of(const Place& p) const { return this->At + this->S * p[0] + this->T * p[1]; }
  Line Times(const Rational& f) const { return { this->At * f, this->S * f, this->T * f }; }
  Line Plus(const Line& o) const { return { this->At + o.At, this->S + o.S, this->T + o.T }; }
};

// Seen from where the ray begins; not edge-on.
struct SeenTriangle
{
  vtkIdType Cell;
  std::array<Line, 3> Edges; // positive inside
  Line Sum;                  // of them
  Rational Volume;           // over Sum: the distance, in lengths of the direction
};

Outline Cut(const Outline& outline, const Line& line)
{
  Outline kept;
  for (std::size_t i = 0; i < outline.size(); ++i)
  {
    const Place& p = outline[i];
    const Place& q = outline[(i + 1) % outline.size()];
    const Rational a = line.Of(p);
    const Rational b = line.Of(q);
    if (a >= 0)
    {
      kept.push_back(p);
    }
    if ((a > 0 && b < 0) || (a < 0 && b > 0))
    {
      const Rational share = a / (a - b);
      kept.push_back({ { p[0] + (q[0] - p[0]) * share, p[1] + (q[1] - p[1]) * share } });
    }
  }
  return kept;
}

bool HasArea(const Outline& o)
{
  Rational area = 0;
  for (std::size_t i = 2; i < o.size(); ++i)
  {
    area +=
      (o[i - 1][0] - o[0][0]) * (o[i][1] - o[0][1]) - (o[i - 1][1] - o[0][1]) * (o[i][0] - o[0][0]);
  }
  return area != 0;
}

Outline Square() // of all directions
{
  return { { { -1, -1 } }, { { 1, -1 } }, { { 1, 1 } }, { { -1, 1 } } };
}

Place Middle(const Outline& outline)
{
  Place sum{ { 0, 0 } };
  for (const Place& p : outline)
  {
    sum = { { sum[0] + p[0], sum[1] + p[1] } };
  }
  return { { sum[0] / outline.size(), sum[1] / outline.size() } };
}

class Search
{
public:
  Search(const TriangleSoup& soup, const WitnessRequest& ray);
  std::optional<RationalVector> Run(vtkIdType cell);
  bool IsBehindEdges(vtkIdType cell);
  bool IsWellInside(std::size_t triangle) const;

private:
  using Corners = std::array<vec3, 3>; // from where the ray begins

  Corners CornersOf(std::size_t triangle) const;
  double RoomOf(const vec3& a, const vec3& b) const;
  bool MayBeNear(const Corners& w) const;
  void Add(std::size_t triangle);
  void AddAllNear();
  Line LineOf(const RationalVector& plane) const;
  RationalVector DirectionOf(const Place& p) const;
  bool IsShown(const SeenTriangle& triangle, const Place& p) const;
  std::vector<std::size_t> TrianglesNear(vtkIdType cell) const;
  bool IsPassed(const SeenTriangle& own) const;
  const SeenTriangle* Hider(const Place& p, const SeenTriangle* own) const;
  std::optional<Place> Look(Outline outline, const SeenTriangle* own) const;

  const TriangleSoup& Soup;
  WitnessRequest Ray;
  RationalVector Ahead;
  RationalVector Right;
  RationalVector Down;
  std::vector<SeenTriangle> Seen;
};

Search::Search(const TriangleSoup& soup, const WitnessRequest& ray)
  : Soup(soup)
  , Ray(ray)
{
  const vec3 d = ray.Direction;
  const vec3 other = std::abs(d.x) < 0.6 ? vec3(1, 0, 0) : vec3(0, 1, 0);
  const vec3 right = glm::normalize(glm::cross(d, other));
  // to the corners of the square it is less than AnswerAngle; few digits keep the numbers short
  const double half = 0.5 * AnswerAngle;
  const auto shorten = [&](const vec3& v) {
    return Exact(vec3(float(v.x), float(v.y), float(v.z)) * half);
  };
  this->Ahead = Exact(d);
  this->Right = shorten(right);
  this->Down = shorten(glm::cross(d, right));
}

Search::Corners Search::CornersOf(std::size_t triangle) const
{
  const auto& t = this->Soup.Triangles[triangle];
  const std::vector<vec3>& p = this->Soup.Points;
  const vec3 o = this->Ray.Origin;
  return { { p[t[0]] - o, p[t[1]] - o, p[t[2]] - o } };
}

// What the edge function of two corners changes by within the square, and its rounding.
double Search::RoomOf(const vec3& a, const vec3& b) const
{
  return EvaluateEdge(this->Ray.Direction, a, b).Bound +
    ChoiceSafety * AnswerAngle * glm::length(a) * glm::length(b);
}

// False where no direction of the square can be inside; in double, with room for its rounding.
bool Search::MayBeNear(const Corners& w) const
{
  bool up = true;
  bool down = true;
  for (int i = 0; i < 3; ++i)
  {
    const double e = EvaluateEdge(this->Ray.Direction, w[(i + 1) % 3], w[(i + 2) % 3]).Value;
    const double room = this->RoomOf(w[(i + 1) % 3], w[(i + 2) % 3]);
    up = up && e >= -room;
    down = down && e <= room;
  }
  return up || down; // and false of what is no number
}

// True where every direction of the square is.
bool Search::IsWellInside(std::size_t triangle) const
{
  const Corners w = this->CornersOf(triangle);
  bool up = true;
  bool down = true;
  for (int i = 0; i < 3; ++i)
  {
    const double e = EvaluateEdge(this->Ray.Direction, w[(i + 1) % 3], w[(i + 2) % 3]).Value;
    const double room = this->RoomOf(w[(i + 1) % 3], w[(i + 2) % 3]);
    up = up && e > room;
    down = down && e < -room;
  }
  return up || down;
}

Line Search::LineOf(const RationalVector& plane) const
{
  return { Dot(this->Ahead, plane), Dot(this->Right, plane), Dot(this->Down, plane) };
}

RationalVector Search::DirectionOf(const Place& p) const
{
  RationalVector d = this->Ahead;
  for (int i = 0; i < 3; ++i)
  {
    d[i] += p[0] * this->Right[i] + p[1] * this->Down[i];
  }
  return d;
}

void Search::Add(std::size_t triangle)
{
  const auto& t = this->Soup.Triangles[triangle];
  const RationalVector o = Exact(this->Ray.Origin);
  std::array<RationalVector, 3> w;
  for (int i = 0; i < 3; ++i)
  {
    w[i] = Minus(Exact(this->Soup.Points[t[i]]), o);
  }
  const Rational volume = Dot(w[0], Cross(w[1], w[2]));
  if (volume == 0)
  {
    return; // its plane holds the eye
  }
  const Rational sign = volume > 0 ? 1 : -1;
  SeenTriangle seen;
  seen.Cell = this->Soup.CellIds[triangle];
  seen.Volume = volume * sign;
  for (int i = 0; i < 3; ++i)
  {
    seen.Edges[i] = this->LineOf(Cross(w[(i + 1) % 3], w[(i + 2) % 3])).Times(sign);
  }
  seen.Sum = seen.Edges[0].Plus(seen.Edges[1]).Plus(seen.Edges[2]);
  this->Seen.push_back(seen);
}

void Search::AddAllNear()
{
  for (std::size_t t = 0; t < this->Soup.Triangles.size(); ++t)
  {
    if (this->MayBeNear(this->CornersOf(t)))
    {
      this->Add(t);
    }
  }
}

// Inside, and between the clip spheres.
bool Search::IsShown(const SeenTriangle& triangle, const Place& p) const
{
  for (const Line& edge : triangle.Edges)
  {
    if (edge.Of(p) < 0)
    {
      return false;
    }
  }
  const Rational sum = triangle.Sum.Of(p);
  if (sum <= 0)
  {
    return false; // all three edges meet here: it is inside of nothing
  }
  const RationalVector d = this->DirectionOf(p);
  const Rational distance = triangle.Volume / sum;
  const Rational square = distance * distance * Dot(d, d);
  const Rational least(this->Ray.Radii.x);
  const Rational most(this->Ray.Radii.y);
  return square >= least * least && square <= most * most;
}

std::vector<std::size_t> Search::TrianglesNear(vtkIdType cell) const
{
  const std::vector<vtkIdType>& ids = this->Soup.CellIds;
  const auto range = std::equal_range(ids.begin(), ids.end(), cell);
  std::vector<std::size_t> near;
  for (auto id = range.first; id != range.second; ++id)
  {
    const std::size_t triangle = std::size_t(id - ids.begin());
    if (this->MayBeNear(this->CornersOf(triangle)))
    {
      near.push_back(triangle);
    }
  }
  return near;
}

bool IsBefore(const SeenTriangle& one, const SeenTriangle& other, const Place& p)
{
  return one.Volume * other.Sum.Of(p) < other.Volume * one.Sum.Of(p);
}

// The nearest of the triangles before the cell's own, or nullptr.
const SeenTriangle* Search::Hider(const Place& p, const SeenTriangle* own) const
{
  const SeenTriangle* nearest = own;
  for (const SeenTriangle& t : this->Seen)
  {
    const bool before = !nearest || IsBefore(t, *nearest, p);
    if ((!own || t.Cell != own->Cell) && this->IsShown(t, p) && before)
    {
      nearest = &t;
    }
  }
  return nearest == own ? nullptr : nearest;
}

// A place where the cell's triangle (or, with nullptr, nothing) is seen inside the outline.
std::optional<Place> Search::Look(Outline outline, const SeenTriangle* own) const
{
  std::vector<Outline> parts{ std::move(outline) };
  for (int looks = 0; looks < MostLooks && !parts.empty(); ++looks)
  {
    Outline rest = std::move(parts.back());
    parts.pop_back();
    if (!HasArea(rest))
    {
      continue;
    }
    const Place p = Middle(rest);
    const SeenTriangle* const hider = this->Hider(p, own);
    if (!hider && (!own || this->IsShown(*own, p)))
    {
      return p;
    }
    if (!hider)
    {
      continue; // beyond a clip sphere
    }
    std::vector<Line> lines(hider->Edges.begin(), hider->Edges.end());
    if (own)
    {
      lines.push_back(hider->Sum.Times(own->Volume).Plus(own->Sum.Times(-hider->Volume)));
    }
    for (const Line& line : lines)
    {
      parts.push_back(Cut(rest, line.Times(-1)));
      rest = Cut(rest, line);
    }
  }
  return std::nullopt;
}

std::optional<RationalVector> Search::Run(vtkIdType cell)
{
  if (cell >= 0 && this->TrianglesNear(cell).empty())
  {
    return std::nullopt; // the usual case of what is simply wrong
  }
  this->AddAllNear();
  const Outline square = Square();
  if (cell < 0)
  {
    const std::optional<Place> p = this->Look(square, nullptr);
    return p ? std::make_optional(this->DirectionOf(*p)) : std::nullopt;
  }
  for (const SeenTriangle& own : this->Seen)
  {
    if (own.Cell == cell)
    {
      const Outline outline = Cut(Cut(Cut(square, own.Edges[0]), own.Edges[1]), own.Edges[2]);
      if (const std::optional<Place> p = this->Look(outline, &own))
      {
        return this->DirectionOf(*p);
      }
    }
  }
  return std::nullopt;
}

// Whether some direction meets nothing that is before the cell's triangle.
bool Search::IsPassed(const SeenTriangle& own) const
{
  const Place ray{ { 0, 0 } };
  const auto isNot = [&](const SeenTriangle& t) {
    return t.Cell == own.Cell || !IsBefore(t, own, ray);
  };
  Search before = *this;
  before.Seen.erase(
    std::remove_if(before.Seen.begin(), before.Seen.end(), isNot), before.Seen.end());
  return before.Look(Square(), nullptr).has_value();
}

bool Search::IsBehindEdges(vtkIdType cell)
{
  const std::vector<std::size_t> near = this->TrianglesNear(cell);
  if (std::any_of(
        near.begin(), near.end(), [this](std::size_t t) { return this->IsWellInside(t); }))
  {
    return false;
  }
  this->AddAllNear();
  return std::any_of(this->Seen.begin(), this->Seen.end(),
    [&](const SeenTriangle& t) { return t.Cell == cell && this->IsPassed(t); });
}
}

bool IsBehindEdges(const TriangleSoup& soup, const WitnessRequest& ray, vtkIdType cell)
{
  return Search(soup, ray).IsBehindEdges(cell);
}

bool IsWellInside(const TriangleSoup& soup, const WitnessRequest& ray, std::size_t triangle)
{
  return Search(soup, ray).IsWellInside(triangle);
}

std::optional<RationalVector> FindWitness(
  const TriangleSoup& soup, const WitnessRequest& ray, vtkIdType cell)
{
  return Search(soup, ray).Run(cell);
}
}
}
