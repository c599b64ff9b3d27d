// SPDX-License-Identifier: BSD-3-Clause
// What the viewer says of itself: in its log, and on the picture.
#include "Options/Borders.h"
#include "Text/Messages.h"
#include "Viewer.h"

#include <cstdio>

namespace widefov
{
namespace
{
std::string TextOfView(const Options& o)
{
  const bool round = wfv::FindProjection(o.Projection)->Axis == wfv::Family::Azimuthal;
  double across = o.View.HorizontalFov;
  double up = o.View.VerticalFov;
  if (o.Part)
  {
    const std::array<double, 4> borders = BordersOf(o);
    across = borders[1] - borders[0];
    up = borders[3] - borders[2];
  }
  char line[256];
  std::snprintf(line, sizeof(line), "%.1f", across);
  const std::string text = o.Projection + "  " + line;
  std::snprintf(line, sizeof(line), " x %.1f", up);
  return text + (round ? std::string() : std::string(line)) + " degrees";
}

std::string TextOfScreens(const Options& o, std::size_t count)
{
  char line[256];
  std::snprintf(line, sizeof(line), "  room scale %.4g", o.RoomScale);
  return std::to_string(count) + (count == 1 ? " screen" : " screens") + line;
}

// Lines for those who ask what a frame took.
std::string NumbersOf(const Options& o, const FrameCost& cost)
{
  char line[256];
  std::snprintf(line, sizeof(line), "  %.1f ms", cost.Milliseconds);
  std::string text = "\n" + o.TechniqueName + line;
  if (cost.Draws)
  {
    const DrawCounts& d = *cost.Draws;
    std::snprintf(line, sizeof(line), "\ndraws: plain %d  pre-clip %d  tessellate %d  exact %d",
      d.Plain, d.PreClip, d.Tessellate, d.Exact);
    text += line;
    std::snprintf(line, sizeof(line), "\nprops: %d of %d  cluster triangles: %lld of %lld", d.Props,
      d.Props + d.PropsCulled, d.Triangles - d.TrianglesCulled, d.Triangles);
    text += line;
  }
  return text;
}
}

void Viewer::Log(const std::string& event)
{
  ViewerState state;
  state.Event = event;
  state.Frame = this->Frames;
  state.Cursor = this->At.At;
  if (const std::optional<Vector3> ray = this->RayUnderPointer())
  {
    state.UnderCursor = this->Head.ToWorld(*ray);
  }
  const Options part = this->Parts()[this->At.Part];
  state.Screen = part.Screen ? part.Screen->Name : "";
  state.Pose = this->Around.GetNumber();
  state.Paused = this->Paused;
  if (this->Time)
  {
    state.Time = ViewerState::TimeState{ this->Time->GetStep() + 1, this->Time->GetCount(),
      this->Time->GetTime(), this->Time->IsPlaying() };
  }
  state.Crosshair = this->ShowsCrosshair ? this->Cross.At : std::nullopt;
  state.Yaw = this->Head.GetYaw();
  state.Pitch = this->Head.GetPitch();
  state.Pending =
    this->Dirty || !this->Held.empty() || this->WantedStep || (this->Shown && this->Unsettled > 0);
  state.FullScreen = this->Windows.IsFullScreen();
  state.Help = this->ShowsHelp;
  state.Text = this->ShowsText;
  state.Numbers = this->ShowsNumbers;
  state.HasPanel = this->Shown != nullptr;
  state.Widgets = this->Places;
  state.Message = this->Message;
  state.Cost = this->Cost;
  this->Lines.Write(state, this->Now);
}

std::string Viewer::TextFor(const FrameCost& cost) const
{
  if (!this->ShowsText)
  {
    return "";
  }
  const std::size_t screens = this->Parts().size();
  std::string text =
    this->Around.HasScreens() ? TextOfScreens(this->Now, screens) : TextOfView(this->Now);
  if (const std::optional<std::size_t> pose = this->Around.GetNumber())
  {
    text += "  pose " + std::to_string(*pose) + (this->Paused ? ", stopped" : "");
  }
  text += this->TextOfTime();
  text += this->ShowsNumbers ? NumbersOf(this->Now, cost) : "";
  const std::string hint = HasPanels() ? "F1: keys, Tab: panel" : "F1: keys";
  return text + "\n" + (this->Message.empty() ? hint : this->Message);
}
}
