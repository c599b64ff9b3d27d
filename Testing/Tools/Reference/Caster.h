// SPDX-License-Identifier: BSD-3-Clause
// What a drawn picture is measured against, whatever the scene is made of.
#ifndef WideFoVCaster_h
#define WideFoVCaster_h

#include "Projections/Projection.h"
#include "TriangleSoup.h"

#include <vtkType.h>

#include <limits>
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
  vec3 Normal{ 0 };      // of balls, sticks and hulls: towards the eye, unit length
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

// True where all places within `slack` pixels of a pixel's centre, along the axes, are in the
// map, or none is; which of the two is told.
bool IsClear(const View& view, int i, int j, int width, int height, double slack, bool& inside);

class Caster
{
public:
  explicit Caster(const View& view)
    : TheView(view)
  {
  }
  virtual ~Caster() = default;

  // The nearest hit between the clip spheres of the view, for a ray in view coordinates;
  // the direction has unit length. Safe to call from several threads.
  virtual Hit Cast(const vec3& origin, const vec3& direction) const = 0;

  // The same for the ray of a place in the picture, or for the curve that the stereo model of
  // the view makes of it.
  Hit Cast(vec2 ndc) const;

  // Cast for each of these, which are neighbours. Sets all of a hit but InDomain.
  virtual std::vector<Hit> CastTogether(const std::vector<ViewRay>& rays) const;

  // The first hit on the way from one point to another, at most the distance between them;
  // clip spheres do not count. Needed where a stereo model bends rays.
  virtual Hit CastSegment(const vec3&, const vec3&) const { return {}; }

  // Whether Cast(ndc) hits this cell (-1: nothing).
  virtual bool Sees(vec2 ndc, vtkIdType cell) const { return this->Cast(ndc).Cell == cell; }

  // All pixel centres, in parallel over rows of tiles: each has what Cast says of it.
  HitPicture Render(int width, int height) const;

  const View& GetView() const { return this->TheView; }

  // What is cast at, where it is triangles: Hit::Triangle counts them. Else nullptr.
  virtual const TriangleSoup* GetSoup() const { return nullptr; }

protected:
  View TheView;

private:
  // Between two depths, in so many straight pieces.
  Hit CastCurve(vec2 ndc, double near, double far, int pieces) const;

  // Those of a tile of the picture, whose upper left pixel is (left, top).
  void RenderTile(HitPicture& picture, int left, int top) const;

  // The first hit on the way along these places.
  Hit CastPoints(const std::vector<vec3>& places) const;
};
}
}

#endif
