// SPDX-License-Identifier: BSD-3-Clause
#include "Caster.h"

#include <vtkSMPTools.h>

#include <algorithm>

namespace wfv
{
namespace reference
{
vec2 PixelToNdc(double x, double y, int width, int height)
{
  return vec2(2 * x / width - 1, 1 - 2 * y / height);
}

bool IsClear(const View& view, int i, int j, int w, int h, double slack, bool& inside)
{
  inside = view.Ray(PixelToNdc(i + 0.5, j + 0.5, w, h)).Inside;
  for (double d : { -slack, slack })
  {
    if (view.Ray(PixelToNdc(i + 0.5 + d, j + 0.5, w, h)).Inside != inside ||
      view.Ray(PixelToNdc(i + 0.5, j + 0.5 + d, w, h)).Inside != inside)
    {
      return false;
    }
  }
  return true;
}

namespace
{
// Straight pieces of a curve from the near to the far sphere, and of the piece that hits.
constexpr int CurvePieces = 128;
constexpr int FinePieces = 32;

// Pixels along the side of a tile, whose rays are cast together.
constexpr int TileSize = 8;

// Steps of the bisection for the end of a volume: the last digit of its depth.
constexpr int BorderSteps = 50;

struct CurvePoint
{
  double Depth; // NDC, -1 to 1
  vec3 Place;
  bool Inside;
};

// What a place of the picture shows at a depth.
CurvePoint PointAt(const View& view, vec2 ndc, double depth)
{
  const ViewRay ray = view.RayAt(vec3(ndc.x, ndc.y, depth));
  const double rho = wfvDistanceAt(0.5 * (depth + 1), view.GetParameters());
  return { depth, ray.Origin + ray.Direction * rho, ray.Inside };
}

// Of two points, one inside and one outside, the one inside moved to the border between them.
CurvePoint BorderBetween(const View& view, vec2 ndc, CurvePoint in, CurvePoint out)
{
  for (int i = 0; i < BorderSteps; ++i)
  {
    const CurvePoint middle = PointAt(view, ndc, 0.5 * (in.Depth + out.Depth));
    (middle.Inside ? in : out) = middle;
  }
  return in;
}

// The points of a piece of the curve between which it is straight enough, in order. Beside a
// border it may turn as the square root of the depth from there: short steps first, even ones
// in that root.
std::vector<CurvePoint> PointsOf(const View& view, vec2 ndc, CurvePoint from, CurvePoint to)
{
  if (from.Inside && to.Inside)
  {
    return { from, to };
  }
  const CurvePoint border =
    from.Inside ? BorderBetween(view, ndc, from, to) : BorderBetween(view, ndc, to, from);
  const CurvePoint other = from.Inside ? from : to;
  std::vector<CurvePoint> points{ border };
  for (int i = 1; i <= FinePieces; ++i)
  {
    const double t = double(i) / FinePieces;
    points.push_back(PointAt(view, ndc, border.Depth + (other.Depth - border.Depth) * t * t));
  }
  if (from.Inside)
  {
    std::reverse(points.begin(), points.end());
  }
  return points;
}
}

Hit Caster::CastPoints(const std::vector<vec3>& places) const
{
  for (std::size_t i = 0; i + 1 < places.size(); ++i)
  {
    Hit hit = this->CastSegment(places[i], places[i + 1]);
    if (hit.Cell >= 0)
    {
      // the eye of the map is the origin
      const vec3 along = glm::normalize(places[i + 1] - places[i]);
      hit.Distance = glm::length(places[i] + along * hit.Distance);
      hit.InDomain = true;
      return hit;
    }
  }
  return {};
}

Hit Caster::CastCurve(vec2 ndc, double near, double far, int pieces) const
{
  Hit nothing;
  CurvePoint from = PointAt(this->TheView, ndc, near);
  for (int i = 1; i <= pieces; ++i)
  {
    const CurvePoint to = PointAt(this->TheView, ndc, near + (far - near) * i / pieces);
    nothing.InDomain = nothing.InDomain || from.Inside || to.Inside;
    if (from.Inside || to.Inside)
    {
      std::vector<vec3> places;
      for (const CurvePoint& point : PointsOf(this->TheView, ndc, from, to))
      {
        places.push_back(point.Place);
      }
      const Hit hit = this->CastPoints(places);
      if (hit.Cell >= 0)
      {
        const Hit finer =
          pieces == CurvePieces ? this->CastCurve(ndc, from.Depth, to.Depth, FinePieces) : Hit();
        return finer.Cell >= 0 ? finer : hit;
      }
    }
    from = to;
  }
  return nothing;
}

Hit Caster::Cast(vec2 ndc) const
{
  const StereoModel* const model = this->TheView.GetStereoModel();
  if (model && !model->Traits.StraightRays)
  {
    return this->CastCurve(ndc, -1, 1, CurvePieces);
  }
  const ViewRay ray = this->TheView.Ray(ndc);
  if (!ray.Inside)
  {
    return {};
  }
  Hit hit = this->Cast(ray.Origin, ray.Direction);
  hit.InDomain = true;
  return hit;
}

std::vector<Hit> Caster::CastTogether(const std::vector<ViewRay>& rays) const
{
  std::vector<Hit> hits;
  for (const ViewRay& ray : rays)
  {
    hits.push_back(this->Cast(ray.Origin, ray.Direction));
  }
  return hits;
}

void Caster::RenderTile(HitPicture& picture, int left, int top) const
{
  const StereoModel* const model = this->TheView.GetStereoModel();
  const bool straight = !model || model->Traits.StraightRays;
  std::vector<ViewRay> rays;
  std::vector<Hit*> hits;
  for (int j = top; j < std::min(top + TileSize, picture.Height); ++j)
  {
    for (int i = left; i < std::min(left + TileSize, picture.Width); ++i)
    {
      const vec2 ndc = PixelToNdc(i + 0.5, j + 0.5, picture.Width, picture.Height);
      Hit& hit = picture.Hits[std::size_t(j) * picture.Width + i];
      if (!straight)
      {
        hit = this->Cast(ndc);
      }
      else if (const ViewRay ray = this->TheView.Ray(ndc); ray.Inside)
      {
        rays.push_back(ray);
        hits.push_back(&hit);
      }
    }
  }
  const std::vector<Hit> cast = this->CastTogether(rays);
  for (std::size_t n = 0; n < hits.size(); ++n)
  {
    *hits[n] = cast[n];
    hits[n]->InDomain = true;
  }
}

HitPicture Caster::Render(int width, int height) const
{
  HitPicture picture;
  picture.Width = width;
  picture.Height = height;
  picture.Hits.resize(std::size_t(width) * height);
  const int rows = (height + TileSize - 1) / TileSize;
  vtkSMPTools::For(0, rows, 1, [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType row = begin; row < end; ++row)
    {
      for (int left = 0; left < width; left += TileSize)
      {
        this->RenderTile(picture, left, int(row) * TileSize);
      }
    }
  });
  return picture;
}
}
}
