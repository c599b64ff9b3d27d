// SPDX-License-Identifier: BSD-3-Clause
// What is on the panel: widgets for what keys do, and for the look of the data.
#include "Options/StereoChoice.h"
#include "Options/StereoLayout.h"
#include "Presets/Presets.h"
#include "Scenes/ColorMaps.h"
#include "Scenes/Datasets.h"
#include "Stereo/Stereo.h"
#include "Viewer.h"
#include "Viewing/Choices.h"

#include <imgui.h>
#include <vtkMath.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

namespace widefov
{
namespace
{
constexpr float Border = 8;           // between the panel and the window
constexpr float ItemWidth = 13.5F;    // letters' sizes
constexpr float WidestItem = 0.5F;    // of the window's width, at most
constexpr float LeastAngle = 1;       // degrees
constexpr float LeastOpacity = 0.05F; // of volumes, times what is usual
constexpr float MostOpacity = 20;
constexpr float MostTilt = 90; // degrees
constexpr const char* OwnScalars = "(the data's own)";

// Pixels of the window: left, top, right, bottom.
std::array<double, 4> PixelsOf(const ImVec2& from, const ImVec2& to)
{
  const ImVec2 scale = ImGui::GetIO().DisplayFramebufferScale;
  return { { from.x * scale.x, from.y * scale.y, to.x * scale.x, to.y * scale.y } };
}

std::vector<std::string> ProjectionNames()
{
  std::vector<std::string> names;
  for (const wfv::Projection* const p : wfv::AllProjections())
  {
    names.push_back(p->Name);
  }
  return names;
}

std::vector<std::string> WindowLayouts(const Options& o)
{
  std::vector<std::string> names;
  for (const std::string& name : StereoLayoutNames())
  {
    Options next = o;
    next.Layout = name;
    if (FitsWindow(next))
    {
      names.push_back(name);
    }
  }
  return names;
}

std::vector<std::string> ArraysOf(const Scene& scene)
{
  std::vector<std::string> names;
  for (const SceneProp& prop : scene.Props)
  {
    for (const std::string& name : ArrayNames(prop.Source))
    {
      if (std::find(names.begin(), names.end(), name) == names.end())
      {
        names.push_back(name);
      }
    }
  }
  return names;
}
}

void Viewer::Widgets()
{
  this->Places.clear();
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({ size.x - Border, Border }, ImGuiCond_Always, { 1, 0 });
  ImGui::SetNextWindowSizeConstraints({ 0, 0 }, { size.x, std::max(1.F, size.y - 2 * Border) });
  if (ImGui::Begin("Panel (Tab)", nullptr,
        ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoMove |
          ImGuiWindowFlags_NoSavedSettings))
  {
    ImGui::PushItemWidth(std::min(ItemWidth * ImGui::GetFontSize(), WidestItem * size.x));
    this->ChoosePreset();
    this->ChooseView();
    this->ChooseEyes();
    this->ChooseLook();
    this->ChooseFile();
    this->ChooseTime();
    this->ChooseRest();
    ImGui::PopItemWidth();
  }
  const ImVec2 from = ImGui::GetWindowPos();
  const ImVec2 extent = ImGui::GetWindowSize();
  this->PanelArea = PixelsOf(from, { from.x + extent.x, from.y + extent.y });
  this->HasPopup =
    ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
  ImGui::End();
}

// Where the last widget is, for who drives the viewer by its log.
void Viewer::Locate(const std::string& widget)
{
  if (ImGui::IsItemVisible())
  {
    this->Places[widget] = PixelsOf(ImGui::GetItemRectMin(), ImGui::GetItemRectMax());
  }
}

// True where another value was chosen.
bool Viewer::Choose(
  const std::string& what, std::string& value, const std::vector<std::string>& from)
{
  const std::string before = value;
  if (ImGui::BeginCombo(what.c_str(), before.c_str()))
  {
    for (const std::string& name : from)
    {
      if (ImGui::Selectable(name.c_str(), name == before))
      {
        value = name;
      }
      this->Locate(what + "/" + name);
    }
    ImGui::EndCombo();
  }
  this->Locate(what);
  return value != before;
}

bool Viewer::Slide(const std::string& what, double& value, double least, double most)
{
  auto number = static_cast<float>(value);
  const bool other = ImGui::SliderFloat(what.c_str(), &number, static_cast<float>(least),
    static_cast<float>(most), "%.1f", ImGuiSliderFlags_AlwaysClamp);
  this->Locate(what);
  value = other ? number : value;
  return other;
}

void Viewer::Press(const char* label, Action action)
{
  if (ImGui::Button(label))
  {
    this->Pressed.push_back(action);
  }
  this->Locate(label);
}

void Viewer::Check(const char* label, bool on, Action action)
{
  if (ImGui::Checkbox(label, &on))
  {
    this->Pressed.push_back(action);
  }
  this->Locate(label);
}

// The window keeps its size.
void Viewer::ChoosePreset()
{
  std::vector<std::string> names;
  for (const wfv::Preset& preset : wfv::Presets())
  {
    if (!preset.ViewTitle.empty())
    {
      names.push_back(preset.Name);
    }
  }
  std::string name;
  if (this->Around.HasScreens() || !this->Choose("preset", name, names))
  {
    return;
  }
  const bool done =
    SetPreset(this->Now, this->Angles, *wfv::FindPreset(name), this->What, this->Windows.IsTiled());
  this->Say(done ? "preset: " + name : name + " cannot be shown here");
}

// What the flat screens of a room show follows from their corners.
void Viewer::ChooseView()
{
  const bool tiled = this->Windows.IsTiled();
  std::string name = this->Now.Projection;
  if (!this->Around.HasScreens())
  {
    if (this->Choose("projection", name, ProjectionNames()))
    {
      const bool done = SetProjection(this->Now, this->Angles, name, tiled);
      this->Say(done ? "" : name + " cannot be shown here");
    }
    this->ChooseAngles();
  }
  name = this->Now.TechniqueName;
  if (this->Choose("technique", name, TechniqueNames()))
  {
    const bool done = SetTechnique(this->Now, name, tiled);
    this->Say(done ? "" : name + " cannot draw this view");
  }
}

void Viewer::ChooseAngles()
{
  const wfv::Projection& p = *wfv::FindProjection(this->Now.Projection);
  double degrees = this->Now.View.HorizontalFov;
  if (this->Slide("field of view", degrees, std::max<double>(LeastAngle, p.MinHorizontalFov),
        p.MaxHorizontalFov))
  {
    const double before = this->Now.View.HorizontalFov;
    const auto half = [](double angle) { return std::tan(0.5 * angle * vtkMath::Pi() / 180); };
    this->ZoomBy(p.Axis == wfv::Family::Planar ? half(degrees) / half(before) : degrees / before);
  }
  wfv::ViewOptions view = this->Now.View;
  if (this->Slide("tilt", view.Tilt, -MostTilt, MostTilt))
  {
    const bool done = SetView(this->Now, view, this->Windows.IsTiled());
    this->Say(done ? "" : "this view cannot be tilted so");
  }
}

void Viewer::ChooseEyes()
{
  if (this->Around.HasScreens())
  {
    return; // key O
  }
  std::string name = this->Now.Stereo;
  if (this->Choose("stereo", name, StereoNames()))
  {
    const bool done = SetStereo(this->Now, name, this->Windows.IsTiled());
    this->Say(done ? "" : name + " does not go with this view");
  }
  if (!HasTwoEyes(this->Now))
  {
    return;
  }
  if (this->Choose("layout", this->Now.Layout, WindowLayouts(this->Now)))
  {
    this->Changed();
  }
  wfv::ViewOptions view = this->Now.View;
  if (this->ChooseNumbers(view.Stereo))
  {
    const bool done = SetView(this->Now, view, this->Windows.IsTiled());
    this->Say(done ? "" : "the eyes cannot be so");
  }
}

// Those of the model; true where one is another.
bool Viewer::ChooseNumbers(wfv::StereoOptions& s)
{
  using Number = wfv::StereoNumber;
  const std::pair<Number, std::pair<const char*, double*>> all[] = {
    { Number::InterpupillaryDistance, { "ipd", &s.InterpupillaryDistance } },
    { Number::CircleConvergence, { "convergence", &s.CircleConvergence } },
    { Number::Iod, { "iod", &s.Iod } }, { Number::Distance, { "distance", &s.Distance } },
    { Number::Offset, { "offset", &s.Offset } },
    { Number::Separation, { "separation", &s.Separation } },
    { Number::Convergence, { "convergence", &s.Convergence } }
  };
  bool other = false;
  for (const auto& [number, widget] : all)
  {
    if (StereoOf(this->Now).Has(number))
    {
      const double step = std::max(0.1 * std::abs(*widget.second), 1e-6);
      other = ImGui::InputDouble(widget.first, widget.second, step, 0, "%.4g") || other;
      this->Locate(widget.first);
    }
  }
  return other;
}

// What needs the data once more is done after the layout.
void Viewer::ChooseLook()
{
  ImGui::Separator();
  Options next = this->Given.Picture;
  std::vector<std::string> arrays = ArraysOf(this->What);
  arrays.insert(arrays.begin(), OwnScalars);
  std::string name = next.Look.ColorBy.empty() ? OwnScalars : next.Look.ColorBy;
  bool other = this->Choose("colour by", name, arrays);
  if (other)
  {
    next.Look.Range.reset(); // that of another array
  }
  next.Look.ColorBy = name == OwnScalars ? "" : name;
  other = this->Choose("colour map", next.Look.ColorMap, ColorMapNames()) || other;
  other = this->Choose("drawn as", next.Look.Representation,
            { "surface", "surface-with-edges", "wireframe", "points" }) ||
    other;
  other = ImGui::Checkbox("bar of colours", &next.Look.ScalarBar) || other;
  this->Locate("bar of colours");
  if (other)
  {
    this->Wanted = next;
  }
  this->ChooseOpacity();
  std::array<float, 3> color;
  std::copy(this->Now.Background.begin(), this->Now.Background.end(), color.begin());
  if (ImGui::ColorEdit3("background", color.data(), ImGuiColorEditFlags_NoInputs))
  {
    std::copy(color.begin(), color.end(), this->Now.Background.begin());
    this->Changed();
  }
  this->Locate("background");
}

void Viewer::ChooseOpacity()
{
  if (this->What.Volumes.empty())
  {
    return;
  }
  auto factor = static_cast<float>(this->Given.Picture.Look.VolumeOpacity);
  if (ImGui::SliderFloat("opacity", &factor, LeastOpacity, MostOpacity, "%.2f",
        ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_Logarithmic))
  {
    this->Given.Picture.Look.VolumeOpacity = this->Now.Look.VolumeOpacity = factor;
    this->Windows.SetVolumeOpacity(factor);
    this->Changed();
  }
  this->Locate("opacity");
}

// The last ones first.
void Viewer::ChooseFile()
{
  std::string file;
  if (!this->Recently.empty() && this->Choose("open again", file, this->Recently))
  {
    this->WantedFiles = { file };
  }
}

void Viewer::ChooseTime()
{
  if (!this->Time)
  {
    return;
  }
  const auto last = static_cast<int>(this->Time->GetCount()) - 1;
  auto step = static_cast<int>(this->WantedStep.value_or(this->Time->GetStep()));
  char text[64];
  std::snprintf(text, sizeof(text), "%g", this->Time->GetTime());
  if (ImGui::SliderInt("time", &step, 0, last, text, ImGuiSliderFlags_AlwaysClamp))
  {
    this->Time->Play(false, TimeLine::Clock::now());
    this->WantedStep = static_cast<std::size_t>(step);
  }
  this->Locate("time");
  this->Check("play", this->Time->IsPlaying(), Action::TogglePlay);
}

void Viewer::ChooseRest()
{
  ImGui::Separator();
  this->Check("text", this->ShowsText, Action::ToggleText);
  ImGui::SameLine();
  this->Check("numbers", this->ShowsNumbers, Action::ToggleNumbers);
  ImGui::SameLine();
  this->Check("crosshair", this->ShowsCrosshair, Action::ToggleCrosshair);
  this->Check("preview", this->Windows.HasPreview(), Action::NextPreview);
  this->Press("screenshot", Action::Screenshot);
  ImGui::SameLine();
  this->Press("add pose", Action::AddPose);
  ImGui::SameLine();
  this->Press("save session", Action::SaveSession);
  this->Press("command", Action::PrintCommand);
  ImGui::SameLine();
  this->Press("beginning", Action::Reset);
  ImGui::SameLine();
  this->Press("full screen", Action::ToggleFullScreen);
  ImGui::SameLine();
  this->Press("quit", Action::Quit);
}
}
