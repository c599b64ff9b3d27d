// SPDX-License-Identifier: BSD-3-Clause
// What the keys do.
#include "Screenshot.h"
#include "Text/Messages.h"
#include "Viewer.h"
#include "Viewing/Choices.h"
#include "Viewing/CommandText.h"

#include <iostream>

namespace widefov
{
namespace
{
constexpr double TurnStep = 5; // degrees, an arrow key
}

void Viewer::Do(Action action)
{
  if (this->StepTime(action) || this->StepScreens(action) || this->DoView(action) ||
    this->DoText(action))
  {
    this->Changed();
    return;
  }
  switch (action)
  {
    case Action::Screenshot:
      this->TakeScreenshot();
      break;
    case Action::AddPose:
      this->AddPose();
      break;
    case Action::SaveSession:
      this->SaveSession();
      break;
    case Action::PrintCommand:
      std::cout << CommandText(this->Given.Picture, this->ForFiles()) << std::endl;
      this->Say("the command is on standard output");
      break;
    case Action::ToggleCrosshair:
      this->ToggleCrosshair();
      break;
    case Action::TogglePlay:
      this->TogglePlay();
      break;
    default:
      this->DoWindow(action);
      break;
  }
}

// Those of windows.
void Viewer::DoWindow(Action action)
{
  switch (action)
  {
    case Action::ToggleFullScreen:
      if (!this->Windows.SetFullScreen(!this->Windows.IsFullScreen()))
      {
        this->Say("there are fewer monitors than windows");
      }
      break;
    case Action::NextMonitor:
      this->Windows.NextMonitor();
      break;
    case Action::NextPreview:
      this->NextPreview();
      break;
    case Action::TogglePanel:
      this->TogglePanel();
      break;
    case Action::Leave:
      this->Leave();
      break;
    case Action::Quit:
      this->Windows.Close();
      break;
    default:
      break;
  }
}

// Text on the picture. False where it is none of it.
bool Viewer::DoText(Action action)
{
  switch (action)
  {
    case Action::ToggleText:
      this->ShowsText = !this->ShowsText;
      return true;
    case Action::ToggleNumbers:
      this->ShowsNumbers = !this->ShowsNumbers;
      return true;
    case Action::ToggleHelp:
      this->ShowsHelp = !this->ShowsHelp;
      return true;
    default:
      return false;
  }
}

// Those that change what is shown. False where it is none of them.
bool Viewer::DoView(Action action)
{
  switch (action)
  {
    case Action::NextProjection:
    case Action::PreviousProjection:
      StepProjection(this->Now, this->Angles, action == Action::NextProjection ? 1 : -1,
        this->Windows.IsTiled());
      return true;
    case Action::NextTechnique:
    case Action::PreviousTechnique:
      if (!StepTechnique(
            this->Now, action == Action::NextTechnique ? 1 : -1, this->Windows.IsTiled()))
      {
        this->Message = "there is no other technique for this";
      }
      return true;
    case Action::ToggleDebugView:
      if (!SetDebugView(this->Now, !this->Now.DebugView))
      {
        this->Message = "there is no debug view of this projection and technique";
      }
      return true;
    case Action::ZoomIn:
    case Action::ZoomOut:
      this->Zoom(action == Action::ZoomIn ? 1 : -1);
      return true;
    default:
      return this->StepEyes(action) || this->DoHead(action);
  }
}

// The stereo model, and where the eyes go.
bool Viewer::StepEyes(Action action)
{
  const bool forth = action == Action::NextStereo || action == Action::NextLayout;
  const int step = forth ? 1 : -1;
  if (action == Action::NextStereo || action == Action::PreviousStereo)
  {
    const bool other = StepStereo(this->Now, step, this->Windows.IsTiled());
    this->Message = other ? "stereo: " + this->Now.Stereo : "there is no stereo model for this";
    return true;
  }
  if (action == Action::NextLayout || action == Action::PreviousLayout)
  {
    const bool other = StepLayout(this->Now, step);
    this->Message = other ? "layout: " + this->Now.Layout : "without stereo there is no layout";
    if (ShowsEyesInTurn(this->Now) && !this->Windows.HasBuffersForBoth())
    {
      this->Message += ", in turn by software";
    }
    return true;
  }
  return false;
}

// Those that turn the head.
bool Viewer::DoHead(Action action)
{
  switch (action)
  {
    case Action::TurnLeft:
    case Action::TurnRight:
      this->Head.Turn(action == Action::TurnRight ? TurnStep : -TurnStep, 0);
      break;
    case Action::TurnUp:
    case Action::TurnDown:
      this->Head.Turn(0, action == Action::TurnUp ? TurnStep : -TurnStep);
      break;
    case Action::Reset:
      this->Restart();
      break;
    default:
      return false;
  }
  this->TakePose();
  return true;
}

void Viewer::Restart()
{
  const std::array<int, 2> size = this->Now.Size;
  this->Now = this->Given.Picture;
  this->Angles = Fields(this->Given.Picture);
  this->Head = StartOf(this->What, this->Given.Picture);
  this->Now.Size = size;
  if (!this->Around.HasScreens())
  {
    this->Angles.Apply(this->Now);
  }
}

void Viewer::Leave()
{
  if (this->ShowsHelp)
  {
    this->ShowsHelp = false;
    this->Changed();
  }
  else if (this->Shown)
  {
    this->TogglePanel();
  }
  else if (this->Windows.IsFullScreen())
  {
    this->Windows.SetFullScreen(false);
  }
  else
  {
    this->Windows.Close();
  }
}

void Viewer::TakeScreenshot()
{
  try
  {
    const Options shown = this->ForFiles();
    std::vector<Options> parts = this->Parts();
    for (Options& part : parts)
    {
      part.Layout = shown.Layout;
    }
    const std::string file = WriteScreenshot(this->Windows.Take(parts), shown);
    this->Say("written: " + file);
  }
  catch (const Failure& failure)
  {
    widefov::SayError(failure.what()); // no reason to lose the view
    this->Say(failure.what());
  }
}
}
