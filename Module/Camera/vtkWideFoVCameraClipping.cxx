// SPDX-License-Identifier: BSD-3-Clause
// vtkWideFoVCamera: its clip spheres.
#include "vtkWideFoVCamera.h"

#include "Camera/CameraInternals.h"
#include "Camera/PropBounds.h"
#include "Camera/SceneBounds.h"
#include "Camera/SharedDepth.h"
#include "Compat/Reports.h"
#include "Projections/Bounds/ViewFrustum.h"

#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace
{
// Near over far of the automatic clip spheres, where the bounds reach the eye. Linear depth costs
// this no precision far away; at the near sphere a step of depth is a hundredth of the distance.
constexpr double NearOverFar = 1e-6;

// The same where depth is linear in the reciprocal of the distance: it costs precision far away.
constexpr double NearOverFarOfReciprocals = 1e-4;

// The least of logarithmic depth: a step is 2e-6 of the distance, then.
constexpr double LeastNearOverFar = 1e-13;

// Distance at which logarithmic depth begins, as a fraction of the distance to the nearest prop. It
// is small because only a sample of a large mesh is measured.
constexpr double BeforeNearest = 0.01;

// Room, relative, that the automatic clip spheres leave beyond the bounds.
constexpr double ClipMargin = 1e-3;

// Distance from a point to the farthest point of a box.
double FarthestOfBox(const double p[3], const double b[6])
{
  double squared = 0;
  for (int i = 0; i < 3; i++)
  {
    const double away = std::max(std::abs(b[2 * i] - p[i]), std::abs(p[i] - b[2 * i + 1]));
    squared += away * away;
  }
  return std::sqrt(squared);
}

// Returns the corners of a box in view coordinates.
wfv::BoxCorners CornersOf(const double bounds[6], vtkMatrix4x4* toView)
{
  wfv::BoxCorners corners;
  for (int i = 0; i < 8; i++)
  {
    double p[4] = { bounds[i & 1 ? 1 : 0], bounds[i & 2 ? 3 : 2], bounds[i & 4 ? 5 : 4], 1 };
    toView->MultiplyPoint(p, p);
    corners[i] = wfv::vec3(p[0], p[1], p[2]);
  }
  return corners;
}

// The camera of another renderer, if it is one of ours.
vtkWideFoVCamera* FindCamera(vtkRenderer* renderer)
{
  return renderer->IsActiveCameraCreated()
    ? vtkWideFoVCamera::SafeDownCast(renderer->GetActiveCamera())
    : nullptr;
}
}

// Fits the clip spheres of a camera.
struct vtkWideFoVCamera::Clipping
{
  vtkWideFoVCamera* Self;

  // Finds how near and far the view shows parts of a box (xmin, xmax, .., zmax; world), or of a
  // renderer's visible props; known: their bounds, or nullptr.
  wfv::Reach FindReach(const double bounds[6]);
  wfv::Reach FindReachOfProps(vtkRenderer* renderer, const double* known);

  // Sets the clip spheres round what is reached; least: of the near one, scene units.
  void ApplyReach(const wfv::Reach& reach, double least);
  void TakeClipRadii(const std::array<double, 2>& radii);

  // The least radius of an automatic near sphere with this far one, without regard to what is near.
  double FindLeastClipRadius(double farRadius);

  // Returns the distance from the eyes to the nearest of a renderer's props; infinity if none is
  // nearer than `within`. isBounded: what is outside of a frustum does not count.
  double FindNearest(vtkRenderer* renderer, double within, bool isBounded);

  // Returns the least near radius with which the nearest thing is seen if depth permits it; else
  // `least`, with a warning.
  double MakeRoomForNearest(const wfv::Reach& reach, double least);
  void WarnOfClipping(double nearest, double clipped, double farthest);

  // Fits the clip spheres to what a renderer shows, and those that share its depth.
  void Fit(vtkRenderer* renderer);

  // Tests whether depths of both cameras mean the same.
  bool HasDepthOf(vtkWideFoVCamera* other);
  void WarnOfOtherDepths(vtkRenderer* renderer);
};

void vtkWideFoVCamera::SetClipRadii(double nearRadius, double farRadius)
{
  if (!(nearRadius > 0) || !(farRadius > nearRadius) || !std::isfinite(farRadius))
  {
    vtkErrorMacro(<< "The clip spheres need 0 < near < far, not " << nearRadius << " and "
                  << farRadius << "; they are unchanged");
    return;
  }
  this->AutomaticClipRadii = 0;
  this->Internal->Options.Radii = { { nearRadius, farRadius } };
  this->Modified();
}

void vtkWideFoVCamera::GetClipRadii(double radii[2])
{
  std::copy_n(this->Internal->Options.Radii.begin(), 2, radii);
}

double vtkWideFoVCamera::GetNearClipRadius()
{
  return this->Internal->Options.Radii[0];
}

double vtkWideFoVCamera::GetFarClipRadius()
{
  return this->Internal->Options.Radii[1];
}

wfv::Reach vtkWideFoVCamera::Clipping::FindReach(const double bounds[6])
{
  wfv::Reach reach;
  if (!vtkMath::AreBoundsInitialized(bounds))
  {
    return reach;
  }
  double viewpoint[3];
  this->Self->GetViewpoint(viewpoint);
  // seen from a point of the eyes' circle it is that much nearer, or farther
  const double radius = this->Self->GetBaselineRadius();
  reach.Nearest = std::max(wfv::DistanceToBox(viewpoint, bounds) - radius, 0.0);
  reach.Farthest = FarthestOfBox(viewpoint, bounds);
  if (radius == 0 && std::isfinite(reach.Farthest))
  {
    const auto seen = wfv::FarthestSeen(this->Self->GetDrawnProjection(),
      this->Self->Internal->Options, CornersOf(bounds, this->Self->GetModelViewTransformMatrix()));
    reach.IsBounded = seen.has_value();
    reach.Farthest = seen.value_or(reach.Farthest);
  }
  reach.Farthest += radius;
  return reach;
}

double vtkWideFoVCamera::Clipping::FindLeastClipRadius(double farRadius)
{
  const bool even =
    this->Self->IsWide() && this->Self->Internal->Options.Mapping != wfv::DepthMapping::Reversed;
  return farRadius * (even ? NearOverFar : NearOverFarOfReciprocals);
}

void vtkWideFoVCamera::Clipping::ApplyReach(const wfv::Reach& reach, double least)
{
  if (!(reach.Farthest > 0) || !std::isfinite(reach.Farthest))
  {
    return;
  }
  const double f = reach.Farthest * (1 + ClipMargin);
  this->TakeClipRadii({ { std::max(reach.Nearest * (1 - ClipMargin), least), f } });
}

void vtkWideFoVCamera::Clipping::TakeClipRadii(const std::array<double, 2>& radii)
{
  if (radii != this->Self->Internal->Options.Radii)
  {
    this->Self->Internal->Options.Radii = radii;
    this->Self->Modified();
    if (this->Self->IsWide())
    {
      // for those who know no clip spheres
      this->Self->SetClippingRange(radii[0], radii[1]);
    }
  }
}

wfv::Reach vtkWideFoVCamera::Clipping::FindReachOfProps(vtkRenderer* renderer, const double* known)
{
  double bounds[6];
  if (known)
  {
    std::copy_n(known, 6, bounds);
  }
  else
  {
    renderer->ComputeVisiblePropBounds(bounds);
    wfv::HoldOtherBounds(renderer, bounds);
  }
  wfv::LeaveOutEndless(renderer, bounds);
  wfv::InflateForQuadrics(renderer, this->Self->Position, bounds);
  return this->FindReach(bounds);
}

double vtkWideFoVCamera::Clipping::FindNearest(vtkRenderer* renderer, double within, bool isBounded)
{
  double viewpoint[3];
  this->Self->GetViewpoint(viewpoint);
  const double radius = this->Self->GetBaselineRadius();
  wfv::NearThings& things = this->Self->Internal->Things;
  things.Begin(viewpoint, within + radius);
  things.Add(renderer);
  const double nearest = things.Find([this, isBounded](const double box[6]) {
    return !isBounded ||
      wfv::FarthestSeen(this->Self->GetDrawnProjection(), this->Self->Internal->Options,
        CornersOf(box, this->Self->GetModelViewTransformMatrix()));
  });
  // what is inside of the eyes' circle is not seen
  return nearest > radius ? nearest - radius : std::numeric_limits<double>::infinity();
}

double vtkWideFoVCamera::Clipping::MakeRoomForNearest(const wfv::Reach& reach, double least)
{
  double nearest = std::numeric_limits<double>::infinity();
  for (vtkRenderer* const each : this->Self->Internal->Sharing)
  {
    vtkWideFoVCamera* const camera = FindCamera(each);
    nearest = std::min(
      nearest, Clipping{ camera ? camera : this->Self }.FindNearest(each, least, reach.IsBounded));
  }
  double begin = least;
  if (nearest < least && this->Self->IsWide() &&
    this->Self->Internal->Options.Mapping == wfv::DepthMapping::Logarithmic)
  {
    begin = std::max(BeforeNearest * nearest, LeastNearOverFar * reach.Farthest);
  }
  this->WarnOfClipping(nearest, begin, reach.Farthest);
  return begin;
}

void vtkWideFoVCamera::Clipping::WarnOfClipping(double nearest, double clipped, double farthest)
{
  if (nearest < clipped && wfv::IsNews("near sphere"))
  {
    const bool even = this->Self->Internal->Options.Mapping == wfv::DepthMapping::Logarithmic;
    vtkWarningWithObjectMacro(this->Self,
      << "what is nearer to the eye than " << clipped << " is not drawn, and something is "
      << nearest << " away: the farthest thing is " << farthest
      << " away, and depth cannot tell both from the eye; "
      << (even ? "" : "take logarithmic depth (SetDepthMappingToLogarithmic, --depth log), or ")
      << "leave out what is far");
  }
}

bool vtkWideFoVCamera::Clipping::HasDepthOf(vtkWideFoVCamera* other)
{
  const bool fixed = !this->Self->AutomaticClipRadii && !other->AutomaticClipRadii;
  const wfv::ViewOptions& a = this->Self->Internal->Options;
  const wfv::ViewOptions& b = other->Internal->Options;
  return this->Self->IsWide() == other->IsWide() && a.Mapping == b.Mapping &&
    (!fixed || a.Radii == b.Radii);
}

void vtkWideFoVCamera::Clipping::WarnOfOtherDepths(vtkRenderer* renderer)
{
  for (vtkRenderer* const each : this->Self->Internal->Sharing)
  {
    const bool shows = each->VisibleActorCount() + each->VisibleVolumeCount() > 0;
    vtkWideFoVCamera* const camera = each == renderer ? this->Self : FindCamera(each);
    if (shows && !(camera && this->HasDepthOf(camera)) && wfv::IsNews("shared depth"))
    {
      vtkWarningWithObjectMacro(this->Self,
        "renderers with one depth buffer (PreserveDepthBuffer) have depths of "
        "different kinds, so what is nearer may be hidden: give them one camera, or "
        "wide cameras with one DepthMapping and the same ClipRadii");
    }
  }
}

void vtkWideFoVCamera::Clipping::Fit(vtkRenderer* renderer)
{
  wfv::Reach reach;
  for (vtkRenderer* const each : this->Self->Internal->Sharing)
  {
    vtkWideFoVCamera* const camera = each == renderer ? this->Self : FindCamera(each);
    if (camera && !camera->AutomaticClipRadii)
    {
      this->TakeClipRadii(camera->Internal->Options.Radii);
      return;
    }
    if (camera)
    {
      const double* const known = each == renderer ? this->Self->Internal->Bounds : nullptr;
      reach.Add(Clipping{ camera }.FindReachOfProps(each, known));
    }
  }
  double least = this->FindLeastClipRadius(reach.Farthest * (1 + ClipMargin));
  if (reach.Nearest < least && std::isfinite(reach.Farthest))
  {
    least = this->MakeRoomForNearest(reach, least);
  }
  this->ApplyReach(reach, least);
}

void vtkWideFoVCamera::ResetClipRadii(const double bounds[6])
{
  Clipping clipping{ this };
  const wfv::Reach reach = clipping.FindReach(bounds);
  clipping.ApplyReach(reach, clipping.FindLeastClipRadius(reach.Farthest * (1 + ClipMargin)));
}

void vtkWideFoVCamera::FitClipRadii(vtkRenderer* renderer)
{
  wfv::FindRenderersOfDepth(renderer, this->Internal->Sharing);
  Clipping clipping{ this };
  if (this->Internal->Sharing.size() > 1)
  {
    clipping.WarnOfOtherDepths(renderer);
  }
  if (this->AutomaticClipRadii)
  {
    clipping.Fit(renderer);
  }
}
