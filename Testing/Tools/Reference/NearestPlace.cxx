// SPDX-License-Identifier: BSD-3-Clause
// What of the cell may be seen is kept as convex parts, the nearest first. Its nearest place
// is looked at; what hides the cell there is taken away from the part, and so on.
#include "NearestPlace.h"

#include "TangentFrame.h"

#include <algorithm>
#include <cmath>
#include <queue>

namespace wfv
{
namespace reference
{
namespace
{
// Rays a cell: enough for one that shows between a hundred others.
constexpr int MostRays = 400;

// A frame is true to first order. Where a place is this factor farther away in the picture
// than in the frame, nearer parts may follow farther ones: the part is looked at in halves.
constexpr double FrameTrust = 1.05;

struct Part
{
  Polygon Outline;
  double Distance; // in the frame, pixels
  bool operator<(const Part& other) const { return this->Distance > other.Distance; }
};

class Search
{
public:
  Search(const Caster& caster, int width, int height, vec2 place, vtkIdType cell, double limit)
    : TheCaster(caster)
    , Size(width, height)
    , Place(place)
    , Cell(cell)
    , Limit(limit)
    , Frame(caster.GetView(), width, height, place)
  {
  }

  double Run();

private:
  using Triangle = std::array<vec3, 3>;

  void Begin();
  void Look(const Part& part);
  void Add(const Polygon& outline);
  void AddAll(const std::vector<Polygon>& outlines);
  std::vector<Polygon> WithoutWhatHides(const Polygon& outline, vec2 at, const Hit& hit) const;
  vec2 PictureOf(const vec3& direction) const;
  Triangle CornersOf(vtkIdType triangle) const;

  const Caster& TheCaster;
  vec2 Size;
  vec2 Place;
  vtkIdType Cell;
  double Limit;
  TangentFrame Frame;
  std::priority_queue<Part> Parts;
  double Best = std::numeric_limits<double>::infinity();
};

Search::Triangle Search::CornersOf(vtkIdType triangle) const
{
  const TriangleSoup& soup = *this->TheCaster.GetSoup();
  const auto& t = soup.Triangles[std::size_t(triangle)];
  return { { soup.Points[t[0]], soup.Points[t[1]], soup.Points[t[2]] } };
}

void Search::Add(const Polygon& outline)
{
  if (!outline.empty())
  {
    this->Parts.push({ outline, glm::length(NearestToOrigin(outline)) });
  }
}

void Search::AddAll(const std::vector<Polygon>& outlines)
{
  for (const Polygon& outline : outlines)
  {
    this->Add(outline);
  }
}

void Search::Begin()
{
  if (this->Cell < 0)
  {
    const double r = this->Limit;
    this->Add({ vec2(-r, -r), vec2(r, -r), vec2(r, r), vec2(-r, r) });
    return;
  }
  const std::vector<vtkIdType>& ids = this->TheCaster.GetSoup()->CellIds;
  const auto range = std::equal_range(ids.begin(), ids.end(), this->Cell);
  for (auto id = range.first; id != range.second; ++id)
  {
    this->Add(this->Frame.PictureOf(this->CornersOf(id - ids.begin()), this->Limit));
  }
}

// Place in the picture, pixels.
vec2 Search::PictureOf(const vec3& direction) const
{
  const vec2 radii = this->TheCaster.GetView().GetParameters().radii;
  const vec3 ndc =
    this->TheCaster.GetView().Forward(glm::normalize(direction) * (0.5 * (radii.x + radii.y))).Ndc;
  return vec2(0.5 * (ndc.x + 1) * this->Size.x, 0.5 * (1 - ndc.y) * this->Size.y);
}

// Only the part of the other triangle before the cell hides it, where they intersect.
std::vector<Polygon> Search::WithoutWhatHides(const Polygon& outline, vec2 at, const Hit& hit) const
{
  const Triangle other = this->CornersOf(hit.Triangle);
  const double reach = 2 * this->Limit;
  Polygon hidden = this->Frame.PictureOf(other, reach);
  if (this->Cell >= 0)
  {
    const std::vector<vtkIdType>& ids = this->TheCaster.GetSoup()->CellIds;
    const auto own = std::equal_range(ids.begin(), ids.end(), this->Cell);
    if (own.second - own.first == 1)
    {
      const Triangle corners = this->CornersOf(own.first - ids.begin());
      const Polygon before = this->Frame.PictureBefore(other, corners, reach);
      hidden = Holds(before, at) ? before : hidden;
    }
  }
  return Holds(hidden, at) ? Without(outline, hidden) : Halves(outline);
}

void Search::Look(const Part& part)
{
  const vec2 nearest = NearestToOrigin(part.Outline);
  const vec2 inwards = Centroid(part.Outline) - nearest;
  const double most = std::max(glm::length(inwards), 1e-300);
  const vec2 at = nearest + inwards * std::min(0.5, ApartFromEdge / most);
  const vec2 place = this->PictureOf(this->Frame.DirectionAt(at));
  const Hit hit =
    this->TheCaster.Cast(PixelToNdc(place.x, place.y, int(this->Size.x), int(this->Size.y)));
  if (hit.InDomain && hit.Cell == this->Cell)
  {
    const double distance = glm::length(place - this->Place);
    this->Best = std::min(this->Best, distance);
    if (distance > FrameTrust * glm::length(at))
    {
      this->AddAll(Halves(part.Outline));
    }
    return;
  }
  this->AddAll(hit.Cell >= 0 && hit.Cell != this->Cell
      ? this->WithoutWhatHides(part.Outline, at, hit)
      : Halves(part.Outline));
}

double Search::Run()
{
  if (!this->Frame.IsValid())
  {
    return this->Best;
  }
  this->Begin();
  for (int rays = 0; rays < MostRays && !this->Parts.empty(); ++rays)
  {
    const Part part = this->Parts.top();
    if (part.Distance >= std::min(this->Best, this->Limit))
    {
      break;
    }
    this->Parts.pop();
    this->Look(part);
  }
  return this->Best <= this->Limit ? this->Best : std::numeric_limits<double>::infinity();
}
}

double NearestPlace(
  const Caster& caster, int width, int height, vec2 place, vtkIdType cell, double limit)
{
  return caster.GetSoup() ? Search(caster, width, height, place, cell, limit).Run()
                          : std::numeric_limits<double>::infinity();
}
}
}
