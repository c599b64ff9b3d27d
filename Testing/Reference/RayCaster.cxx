// SPDX-License-Identifier: BSD-3-Clause
#include "RayCaster.h"

#include <vtkCellArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSMPThreadLocalObject.h>
#include <vtkStaticCellLocator.h>
#include <vtkVersionMacros.h>

#include <algorithm>

namespace wfv
{
namespace reference
{
namespace
{
// The locator walks its bins in double, and rounding may take it past the corner of one:
// cells are entered in every bin within this fraction of a bin's diagonal, far more than
// rounding amounts to, so no candidate is lost.
constexpr double BinTolerance = 1e-3;

// Lines end this factor beyond the farthest corner of the bounds, so that their end
// takes no part in the decision.
constexpr double Beyond = 1.01;

vtkSmartPointer<vtkPolyData> ToPolyData(const TriangleSoup& soup)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const vec3& p : soup.Points)
  {
    points->InsertNextPoint(p.x, p.y, p.z);
  }
  vtkNew<vtkCellArray> triangles;
  for (const auto& t : soup.Triangles)
  {
    triangles->InsertNextCell(3, t.data());
  }
  auto polyData = vtkSmartPointer<vtkPolyData>::New();
  polyData->SetPoints(points);
  polyData->SetPolys(triangles);
  return polyData;
}
}

struct RayCaster::Locator
{
  vtkSmartPointer<vtkPolyData> Triangles;
  vtkNew<vtkStaticCellLocator> Bins;
  mutable vtkSMPThreadLocalObject<vtkIdList> Ids;
  double Bounds[6];

  explicit Locator(const TriangleSoup& soup)
    : Triangles(ToPolyData(soup))
  {
    this->Triangles->GetBounds(this->Bounds);
    this->Bins->SetDataSet(this->Triangles);
#if VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 2, 0) // later versions bin without a tolerance
    this->Bins->SetUseDiagonalLengthTolerance(true);
#endif
    this->Bins->SetTolerance(BinTolerance);
    if (this->Triangles->GetNumberOfCells() > 0)
    {
      this->Bins->BuildLocator();
    }
  }

  // How far the farthest corner of the bounds lies.
  double Reach(const vec3& o) const
  {
    const double* b = this->Bounds;
    const vec3 r(std::max(std::abs(b[0] - o.x), std::abs(b[1] - o.x)),
      std::max(std::abs(b[2] - o.y), std::abs(b[3] - o.y)),
      std::max(std::abs(b[4] - o.z), std::abs(b[5] - o.z)));
    return Beyond * std::hypot(r.x, std::hypot(r.y, r.z));
  }

  vtkIdList* Find(const vec3& origin, const vec3& direction) const
  {
    return this->FindBetween(origin, origin + direction * this->Reach(origin));
  }

  vtkIdList* FindBetween(const vec3& origin, const vec3& end) const
  {
    const double a[3] = { origin.x, origin.y, origin.z };
    const double b[3] = { end.x, end.y, end.z };
    vtkIdList* ids = this->Ids.Local();
    // VTK 9.1 ignores the tolerance given here for the one set above.
    this->Bins->FindCellsAlongLine(a, b, 0, ids);
    return ids;
  }
};

RayCaster::RayCaster(vtkPolyData* polyData, const View& view, const Pose& worldToView)
  : RayCaster(Triangulate(polyData, worldToView), view)
{
}

RayCaster::RayCaster(TriangleSoup soup, const View& view)
  : reference::Caster(view)
  , Soup(std::move(soup))
  , Candidates(new Locator(Soup))
{
}

RayCaster::~RayCaster() = default;

Hit RayCaster::Cast(const vec3& origin, const vec3& direction) const
{
  Hit best;
  if (this->Soup.Triangles.empty())
  {
    return best;
  }
  vtkIdList* ids = this->Candidates->Find(origin, direction);
  for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
  {
    const vtkIdType id = ids->GetId(i);
    const RayTriangleHit hit = this->Intersect(origin, direction, std::size_t(id));
    const bool nearer =
      hit.Distance < best.Distance || (hit.Distance == best.Distance && id < best.Triangle);
    if (hit.Found && nearer)
    {
      best.Cell = this->Soup.CellIds[id];
      best.Triangle = id;
      best.Distance = hit.Distance;
      best.Barycentrics = hit.Barycentrics;
    }
  }
  return best;
}

// Between the clip spheres.
RayTriangleHit RayCaster::Intersect(
  const vec3& origin, const vec3& direction, std::size_t triangle) const
{
  const auto& t = this->Soup.Triangles[triangle];
  const auto& p = this->Soup.Points;
  RayTriangleHit hit = IntersectTriangle(origin, direction, { { p[t[0]], p[t[1]], p[t[2]] } });
  const vec2 radii = this->TheView.GetParameters().radii;
  hit.Found = hit.Found && hit.Distance >= radii.x && hit.Distance <= radii.y;
  return hit;
}

Hit RayCaster::CastSegment(const vec3& from, const vec3& to) const
{
  Hit best;
  if (this->Soup.Triangles.empty())
  {
    return best;
  }
  const double length = glm::length(to - from);
  const vec3 direction = (to - from) / length;
  vtkIdList* ids = this->Candidates->FindBetween(from, to);
  for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
  {
    const vtkIdType id = ids->GetId(i);
    const auto& t = this->Soup.Triangles[id];
    const auto& p = this->Soup.Points;
    const RayTriangleHit hit =
      IntersectTriangle(from, direction, { { p[t[0]], p[t[1]], p[t[2]] } });
    if (hit.Found && hit.Distance <= length && hit.Distance < best.Distance)
    {
      best.Cell = this->Soup.CellIds[id];
      best.Triangle = id;
      best.Distance = hit.Distance;
      best.Barycentrics = hit.Barycentrics;
    }
  }
  return best;
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
