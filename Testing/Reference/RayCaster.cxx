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

Hit RayCaster::Nearest(const vec3& origin, const vec3& direction, double least, double most) const
{
  Hit best;
  this->Candidates.Visit(origin, direction, [&](std::size_t triangle) {
    const RayTriangleHit hit = this->Intersect(origin, direction, triangle);
    const vtkIdType id = vtkIdType(triangle);
    const bool nearer =
      hit.Distance < best.Distance || (hit.Distance == best.Distance && id < best.Triangle);
    if (hit.Found && hit.Distance >= least && hit.Distance <= most && nearer)
    {
      best.Cell = this->Soup.CellIds[triangle];
      best.Triangle = id;
      best.Distance = hit.Distance;
      best.Barycentrics = hit.Barycentrics;
    }
    return std::min(best.Distance, most);
  });
  return best;
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
  if (cell < 0 || !ray.Inside || (model && !model->Straight))
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
