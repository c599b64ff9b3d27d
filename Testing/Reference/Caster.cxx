// SPDX-License-Identifier: BSD-3-Clause
#include "Caster.h"

#include <vtkSMPTools.h>

namespace wfv
{
namespace reference
{
vec2 PixelToNdc(double x, double y, int width, int height)
{
  return vec2(2 * x / width - 1, 1 - 2 * y / height);
}

namespace
{
// Straight pieces of a curve from the near to the far sphere, and of the piece that hits.
constexpr int CurvePieces = 128;
constexpr int FinePieces = 32;

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
      const CurvePoint a = from.Inside ? from : BorderBetween(this->TheView, ndc, to, from);
      const CurvePoint b = to.Inside ? to : BorderBetween(this->TheView, ndc, from, to);
      Hit hit = this->CastSegment(a.Place, b.Place);
      if (hit.Cell >= 0)
      {
        const Hit finer =
          pieces == CurvePieces ? this->CastCurve(ndc, from.Depth, to.Depth, FinePieces) : Hit();
        // the eye of the map is the origin
        hit.Distance = glm::length(a.Place + glm::normalize(b.Place - a.Place) * hit.Distance);
        hit.InDomain = true;
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
  if (model && !model->Straight)
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

HitPicture Caster::Render(int width, int height) const
{
  HitPicture picture;
  picture.Width = width;
  picture.Height = height;
  picture.Hits.resize(std::size_t(width) * height);
  vtkSMPTools::For(0, height, 1, [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType j = begin; j < end; ++j)
    {
      for (int i = 0; i < width; ++i)
      {
        picture.Hits[j * width + i] = this->Cast(PixelToNdc(i + 0.5, j + 0.5, width, height));
      }
    }
  });
  return picture;
}
}
}
