// SPDX-License-Identifier: BSD-3-Clause
// The room that the view is seen from, and what the pointer is on.
#include "Options/Borders.h"
#include "Options/StereoChoice.h"
#include "Stereo/Stereo.h"
#include "Viewer.h"
#include "Viewing/Choices.h"

#include <cmath>

namespace widefov
{
namespace
{
constexpr double ZoomStep = 1.1; // the field of view, or the scene's size; a notch of the wheel

using Seconds = std::chrono::duration<double>;
}

std::vector<Options> Viewer::Parts() const
{
  std::vector<Options> parts = this->Around.See(this->Now);
  for (std::size_t i = 0; i < parts.size() && this->Around.HasScreens(); i++)
  {
    parts[i].Size = this->Windows.GetSize(i);
  }
  return parts;
}

// What a file shows of the windows: the eyes in one picture.
Options Viewer::ForFiles() const
{
  Options o = this->Now;
  o.Layout = ShowsEyesInTurn(o) ? Options().Layout : o.Layout;
  if (this->Around.HasScreens())
  {
    const std::vector<Options> parts = this->Parts();
    o.Size = parts[0].Size;
    o.HasSize = true;
    for (const Options& part : parts)
    {
      o.HasSize = o.HasSize && part.Size == o.Size;
    }
  }
  return o;
}

// In an eye's own picture: this layout shows both in half the width.
Place Viewer::Pointed() const
{
  Place place = this->At;
  if (HasTwoEyes(this->Now) && this->Now.Layout == "split")
  {
    const double width = this->Windows.GetSize(place.Part)[0];
    const double right = 2 * place.At[0];
    place.At[0] = right < width ? right : right - width;
  }
  return place;
}

std::optional<Vector3> Viewer::RayUnderPointer() const
{
  const Place place = this->Pointed();
  const Options part = this->Parts()[place.Part];
  if (part.Size[0] <= 0 || part.Size[1] <= 0)
  {
    return std::nullopt;
  }
  const wfv::vec2 ndc =
    InWhole(part, { 2 * place.At[0] / part.Size[0] - 1, 1 - 2 * place.At[1] / part.Size[1] });
  return RayOf(part, ndc.x, ndc.y);
}

// Time goes on from the first frame, whatever a frame takes: what is late is left out.
void Viewer::Play()
{
  const auto now = std::chrono::steady_clock::now();
  const double passed = Seconds(now - this->LastPose).count();
  this->LastPose = now;
  if (this->Frames > 0 && !this->Paused && this->Around.Advance(passed))
  {
    this->Changed();
  }
}

void Viewer::ToggleCrosshair()
{
  if (!this->ShowsCrosshair && this->Now.Technique == Technique::CubeMap)
  {
    this->Say("stock VTK's cubemap has no crosshair");
    return;
  }
  this->ShowsCrosshair = !this->ShowsCrosshair;
  this->Cross = Aim();
  this->Windows.SetPointerShown(!this->ShowsCrosshair);
  this->Changed();
}

void Viewer::NextPreview()
{
  if (!this->Windows.NextPreview())
  {
    this->Say("the preview is of one window, or of screens in a room");
  }
  this->Changed();
}

void Viewer::Zoom(double notches)
{
  const double factor = std::pow(ZoomStep, -notches);
  if (this->Around.HasScreens())
  {
    this->ZoomRoom(factor);
    return;
  }
  this->ZoomBy(factor);
}

void Viewer::ZoomBy(double factor)
{
  if (!this->Angles.Zoom(this->Now, factor))
  {
    this->Say("this projection always shows the same field of view");
    return;
  }
  this->Angles.Apply(this->Now);
  if (GiveUpTechnique(this->Now))
  {
    this->Message = "this field of view is beyond the technique: auto";
  }
  this->Changed();
}

// What screens show follows from their corners: the scene grows, round what is pointed at.
void Viewer::ZoomRoom(double factor)
{
  Vector3 eye = this->Head.GetEye();
  const bool points = this->ShowsCrosshair && this->Cross.At;
  ScaleRoom(this->Now, eye, points ? *this->Cross.At : this->Center, factor);
  this->Head.MoveTo(eye);
  this->TakePose();
}

// Projections and stereo models that flat screens have. False where the action is another.
bool Viewer::StepScreens(Action action)
{
  if (!this->Around.HasScreens())
  {
    return false;
  }
  if (action == Action::NextProjection || action == Action::PreviousProjection)
  {
    this->Message = "what screens show follows from their corners";
    return true;
  }
  if (action != Action::NextStereo && action != Action::PreviousStereo)
  {
    return false;
  }
  Options next = this->Now;
  const wfv::Projection& flat = *wfv::FindProjection("perspective");
  next.View.Stereo.Model = HasTwoEyes(this->Now) ? &wfv::NoStereo() : &wfv::UsualStereo(flat);
  next.Stereo = next.View.Stereo.Model->Name;
  this->Message =
    ShowsCube(this->Now) ? "the volume stays behind its screen" : this->Around.WhyNot(next);
  if (this->Message.empty())
  {
    this->Message = "stereo: " + next.Stereo;
    this->Now = next;
  }
  return true;
}
}
