// SPDX-License-Identifier: BSD-3-Clause
// A ray caster in double precision. A hierarchy of boxes proposes candidates; what is hit is
// decided by RayTriangle.h alone. It shares nothing with the shaders but the
// view's `ray`.
#ifndef WideFoVRayCaster_h
#define WideFoVRayCaster_h

#include "Caster.h"
#include "RayTriangle.h"
#include "TriangleTree.h"

namespace wfv
{
namespace reference
{
class RayCaster : public Caster
{
public:
  // The clip spheres are those of the view. The polydata may be changed afterwards.
  RayCaster(vtkPolyData* polyData, const View& view, const Pose& worldToView);

  // The same of triangles that are in view coordinates already, in the order of their
  // cell ids: a scene of several polydata.
  RayCaster(TriangleSoup soup, const View& view);
  RayCaster(const RayCaster&) = delete;
  RayCaster& operator=(const RayCaster&) = delete;

  // Of two hits at the same distance, the one of the lower triangle.
  Hit Cast(const vec3& origin, const vec3& direction) const override;
  using Caster::Cast;
  std::vector<Hit> CastTogether(const std::vector<ViewRay>& rays) const override;
  Hit CastSegment(const vec3& from, const vec3& to) const override;

  // Without looking at the others where the cell's own triangles are missed already: far
  // cheaper where that is the usual answer.
  bool Sees(vec2 ndc, vtkIdType cell) const override;

  const TriangleSoup& GetTriangles() const { return this->Soup; }
  const TriangleSoup* GetSoup() const override { return &this->Soup; }

private:
  RayTriangleHit Intersect(const vec3& origin, const vec3& direction, std::size_t triangle) const;

  // Of the hits between two distances.
  Hit Nearest(const vec3& origin, const vec3& direction, double least, double most) const;

  // What asks of a triangle, for a visit to candidates, and keeps the nearest.
  struct Search;
  TriangleSoup Soup;
  TriangleTree Candidates; // of Soup
};
}
}

#endif
