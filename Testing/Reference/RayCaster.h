// SPDX-License-Identifier: BSD-3-Clause
// A ray caster in double precision. VTK's static cell locator proposes candidates; what
// is hit is decided by RayTriangle.h alone. It shares nothing with the shaders but the
// view's `ray`.
#ifndef WideFoVRayCaster_h
#define WideFoVRayCaster_h

#include "Projection.h"
#include "RayTriangle.h"
#include "TriangleSoup.h"

#include <limits>
#include <memory>
#include <vector>

namespace wfv
{
namespace reference
{
struct Hit
{
  vtkIdType Cell = -1;     // cell id in the polydata, -1 where nothing is hit
  vtkIdType Triangle = -1; // index into TriangleSoup::Triangles
  double Distance = std::numeric_limits<double>::infinity(); // along the ray, scene units
  vec3 Barycentrics{ 0 };
  bool InDomain = false; // the map has a direction here
};

// A picture of hits, rows from the top.
struct HitPicture
{
  int Width = 0;
  int Height = 0;
  std::vector<Hit> Hits;
  const Hit& At(int i, int j) const { return this->Hits[std::size_t(j) * this->Width + i]; }
};

// NDC of a point of a picture of width x height pixels, x from the left and y from the
// top; pixel (i, j) has its centre at (i + 0.5, j + 0.5).
vec2 PixelToNdc(double x, double y, int width, int height);

class RayCaster
{
public:
  // The clip spheres are those of the view. The polydata may be changed afterwards.
  RayCaster(vtkPolyData* polyData, const View& view, const Pose& worldToView);

  // The same of triangles that are in view coordinates already, in the order of their
  // cell ids: a scene of several polydata.
  RayCaster(TriangleSoup soup, const View& view);
  ~RayCaster();
  RayCaster(const RayCaster&) = delete;
  RayCaster& operator=(const RayCaster&) = delete;

  // The nearest hit between the clip spheres; of two at the same distance, the one of
  // the lower triangle. Safe to call from several threads.
  Hit Cast(vec2 ndc) const;

  // The same for a ray in view coordinates; the direction has unit length.
  Hit Cast(const vec3& origin, const vec3& direction) const;

  // Whether Cast(ndc) hits this cell (-1: nothing), without looking at the others where the
  // cell's own triangles are missed already: far cheaper where that is the usual answer.
  bool Sees(vec2 ndc, vtkIdType cell) const;

  // All pixel centres, in parallel over rows.
  HitPicture Render(int width, int height) const;

  const View& GetView() const { return this->TheView; }
  const TriangleSoup& GetTriangles() const { return this->Soup; }

private:
  struct Locator;
  RayTriangleHit Intersect(const vec3& origin, const vec3& direction, std::size_t triangle) const;
  View TheView;
  TriangleSoup Soup;
  std::unique_ptr<Locator> Candidates;
};
}
}

#endif
