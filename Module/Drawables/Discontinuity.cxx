// SPDX-License-Identifier: BSD-3-Clause
#include "Drawables/Discontinuity.h"

#include "Projections/Bounds/Curvature.h"

#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkType.h"

#include <algorithm>
#include <cmath>

namespace
{
// Angle about a pole or the antipode, degrees, inside which edges of one degree curve
// by more than the default tolerance at the sizes a window has (2048 x 1024): a prop
// that reaches in gets the pre-clip too.
constexpr double MeridianPoleCap = 5;
constexpr double AntipodeCap = 25;

// NDC per squared radian: where a view curves more (wfv::Curvature), edges of one degree may be
// off by more than the default tolerance at these sizes anywhere, and every prop gets the
// pre-clip: 8 * 0.25 / (1024 (pi/180)^2) = 6.4.
constexpr double MostCurvature = 6;

// Radians: the bound of wfv::Curvature is for edges that look no longer.
constexpr double LongestAngle = 0.09;

// Range of the tilted view coordinates of a box in world coordinates.
void ViewBounds(
  const double b[6], const double m[16], const wfv::WfvView& view, double low[3], double high[3])
{
  std::fill_n(low, 3, VTK_DOUBLE_MAX);
  std::fill_n(high, 3, -VTK_DOUBLE_MAX);
  for (int c = 0; c < 8; c++)
  {
    double p[4] = { b[c & 1], b[2 + ((c >> 1) & 1)], b[4 + ((c >> 2) & 1)], 1 };
    vtkMatrix4x4::MultiplyPoint(m, p, p);
    const wfv::vec3 q = wfv::wfvTilt(wfv::vec3(p[0], p[1], p[2]), view);
    for (int i = 0; i < 3; i++)
    {
      low[i] = std::min(low[i], q[i]);
      high[i] = std::max(high[i], q[i]);
    }
  }
}

// Square of the distance of its farthest corner.
double Farthest2(const double low[3], const double high[3])
{
  double sum = 0;
  for (int i = 0; i < 3; i++)
  {
    sum += std::pow(std::max(std::abs(low[i]), std::abs(high[i])), 2);
  }
  return sum;
}

// Makes it so much larger that it holds all that looks no farther from it than `footprint`.
void Grow(double low[3], double high[3], double footprint)
{
  const double by = footprint * std::sqrt(Farthest2(low, high));
  for (int i = 0; i < 3; i++)
  {
    low[i] -= by;
    high[i] += by;
  }
}

// True where the borders of the picture are those of the whole sphere: its discontinuities.
bool ShowsAll(const wfv::Projection& projection, const wfv::WfvView& view)
{
  switch (projection.Axis)
  {
    case wfv::Family::Meridian:
      return view.halfFov.x >= vtkMath::Pi() && view.halfFov.y >= 0.5 * vtkMath::Pi();
    case wfv::Family::Azimuthal:
      return view.maxAngle >= vtkMath::Pi();
    default:
      return projection.Axis == wfv::Family::Faces;
  }
}

// Smallest distance of a rectangle from the origin of its plane.
double NearestInPlane(double low0, double high0, double low1, double high1)
{
  return std::hypot(std::max({ low0, -high0, 0.0 }), std::max({ low1, -high1, 0.0 }));
}

// The same of a box in space.
double Nearest(const double low[3], const double high[3])
{
  const double level = NearestInPlane(low[0], high[0], low[2], high[2]);
  return std::hypot(level, std::max({ low[1], -high[1], 0.0 }));
}

// True unless the box lies on one face of the cube round the eye.
bool MeetsFaceBorder(const double low[3], const double high[3])
{
  for (int axis = 0; axis < 3; axis++)
  {
    const int i = (axis + 1) % 3;
    const int j = (axis + 2) % 3;
    const double ahead = std::max(low[axis], -high[axis]);
    if (ahead > std::max({ -low[i], high[i], -low[j], high[j] }))
    {
      return false;
    }
  }
  return true;
}

// True where a box of tilted view coordinates meets a discontinuity of the projection.
bool MeetsDiscontinuity(
  const wfv::Projection& projection, const double low[3], const double high[3])
{
  if (projection.Axis == wfv::Family::Faces)
  {
    return MeetsFaceBorder(low, high);
  }
  if (projection.Axis == wfv::Family::Meridian)
  {
    const bool seam = low[0] <= 0 && high[0] >= 0 && high[2] >= 0;
    const double height = std::max(std::abs(low[1]), std::abs(high[1]));
    const double cap = std::tan(vtkMath::RadiansFromDegrees(MeridianPoleCap));
    return seam || NearestInPlane(low[0], high[0], low[2], high[2]) <= cap * height;
  }
  // the antipode; what is all ahead may well lie round the axis
  const double cap = std::tan(vtkMath::RadiansFromDegrees(AntipodeCap));
  return high[2] >= 0 && NearestInPlane(low[0], high[0], low[1], high[1]) <= cap * high[2];
}
}

bool vtkWideFoVNeedsPreClip(const wfv::Projection& projection, const wfv::WfvView& view,
  const double bounds[6], const double worldToView[16], double footprint)
{
  if (view.curvature > MostCurvature || (footprint > 0 && !ShowsAll(projection, view)))
  {
    return true;
  }
  double low[3];
  double high[3];
  ViewBounds(bounds, worldToView, view, low, high);
  Grow(low, high, footprint);
  return MeetsDiscontinuity(projection, low, high);
}

namespace
{
// Of the directions in a box: the square of what wfv::SineToSingularity is at least.
double SineToSingularity2(wfv::Family family, const double low[3], const double high[3])
{
  const bool ahead = high[2] <= 0;
  if (family == wfv::Family::Meridian)
  {
    return std::pow(NearestInPlane(low[0], high[0], low[2], high[2]), 2) / Farthest2(low, high);
  }
  if (family == wfv::Family::Azimuthal && !ahead)
  {
    return std::pow(NearestInPlane(low[0], high[0], low[1], high[1]), 2) / Farthest2(low, high);
  }
  return 1;
}
}

double vtkWideFoVChordError(const wfv::Projection& projection, const wfv::WfvView& view,
  const double bounds[6], const double worldToView[16], double longestEdge)
{
  double low[3];
  double high[3];
  ViewBounds(bounds, worldToView, view, low, high);
  const double nearest = Nearest(low, high);
  const double angle = nearest > 0 ? longestEdge / nearest : VTK_DOUBLE_MAX;
  const double sine2 = SineToSingularity2(projection.Axis, low, high);
  // what lies beyond such a rim would be drawn inside it
  const bool folds = projection.FlatRim && high[2] >= 0;
  return angle <= LongestAngle && sine2 > 0 && !folds
    ? 0.125 * view.curvature * angle * angle / sine2
    : VTK_DOUBLE_MAX;
}
