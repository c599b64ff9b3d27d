// SPDX-License-Identifier: BSD-3-Clause
#include "RayCaster.h"

#include <algorithm>

namespace wfv
{
namespace reference
{
RayCaster::RayCaster(vtkPolyData* polyData, const View& view, const Pose& worldToView)
  : RayCaster(Triangulate(polyData, worldToView), view)
{
}

RayCaster::RayCaster(TriangleSoup soup, const View& view)
  : reference::Caster(view)
  , Soup(std::move(soup))
  , Candidates(Soup)
{
}

Hit RayCaster::Cast(const vec3& origin, const vec3& direction) const
{
  const vec2 radii = this->TheView.GetParameters().radii;
  return this->Nearest(origin, direction, radii.x, radii.y);
}

struct RayCaster::Search
{
  const RayCaster& Caster;
  vec3 Origin;
  vec3 Direction;
  double Least;
  double Most;
  Hit Best;

  // The distance beyond which nothing matters.
  double operator()(std::size_t triangle)
  {
    const RayTriangleHit hit = this->Caster.Intersect(this->Origin, this->Direction, triangle);
    const vtkIdType id = vtkIdType(triangle);
    const bool nearer = hit.Distance < this->Best.Distance ||
      (hit.Distance == this->Best.Distance && id < this->Best.Triangle);
    if (hit.Found && hit.Distance >= this->Least && hit.Distance <= this->Most && nearer)
    {
      this->Best.Cell = this->Caster.Soup.CellIds[triangle];
      this->Best.Triangle = id;
      this->Best.Distance = hit.Distance;
      this->Best.Barycentrics = hit.Barycentrics;
    }
    return std::min(this->Best.Distance, this->Most);
  }
};

Hit RayCaster::Nearest(const vec3& origin, const vec3& direction, double least, double most) const
{
  Search search{ *this, origin, direction, least, most, {} };
  this->Candidates.Visit(origin, direction, search);
  return search.Best;
}

std::vector<Hit> RayCaster::CastTogether(const std::vector<ViewRay>& rays) const
{
  std::vector<vec3> directions;
  bool together = !rays.empty();
  for (const ViewRay& ray : rays)
  {
    directions.push_back(ray.Direction);
    together = together && ray.Origin == rays.front().Origin;
  }
  if (!together)
  {
    return Caster::CastTogether(rays);
  }
  const auto parts = this->Candidates.Ahead(BoxRays(rays.front().Origin, directions));
  const vec2 radii = this->TheView.GetParameters().radii;
  std::vector<Hit> hits;
  for (const ViewRay& ray : rays)
  {
    Search search{ *this, ray.Origin, ray.Direction, radii.x, radii.y, {} };
    this->Candidates.Visit(parts, ray.Origin, ray.Direction, search);
    hits.push_back(search.Best);
  }
  return hits;
}

RayTriangleHit RayCaster::Intersect(
  const vec3& origin, const vec3& direction, std::size_t triangle) const
{
  const auto& t = this->Soup.Triangles[triangle];
  const auto& p = this->Soup.Points;
  return IntersectTriangle(origin, direction, { { p[t[0]], p[t[1]], p[t[2]] } });
}

Hit RayCaster::CastSegment(const vec3& from, const vec3& to) const
{
  const double length = glm::length(to - from);
  return this->Nearest(from, (to - from) / length, 0, length);
}

bool RayCaster::Sees(vec2 ndc, vtkIdType cell) const
{
  const StereoModel* const model = this->TheView.GetStereoModel();
  const ViewRay ray = this->TheView.Ray(ndc);
  if (cell < 0 || !ray.Inside || (model && !model->Traits.StraightRays))
  {
    return this->Cast(ndc).Cell == cell;
  }
  const auto range = std::equal_range(this->Soup.CellIds.begin(), this->Soup.CellIds.end(), cell);
  for (auto id = range.first; id != range.second; ++id)
  {
    if (this->Intersect(ray.Origin, ray.Direction, id - this->Soup.CellIds.begin()).Found)
    {
      return this->Cast(ray.Origin, ray.Direction).Cell == cell;
    }
  }
  return false;
}

}
}
