// SPDX-License-Identifier: BSD-3-Clause
#include "Viewer.h"

#include "Pictures/CameraSetup.h"
#include "Text/Messages.h"
#include "Viewing/Choices.h"
#include "XErrors.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace widefov
{
namespace
{
constexpr double OrbitRate = 0.25;    // degrees a pixel
constexpr double FlightTime = 8;      // seconds through the scene
constexpr double FasterFactor = 4;    // with Shift
constexpr double FirstMove = 1. / 30; // seconds that a tap of a key counts for
constexpr double LongestMove = 0.2;   // seconds: a slow frame is no leap
constexpr double LongestWait = 10;    // seconds for a pose: systems count to less than doubles
constexpr double HiddenPause = 0.05;  // seconds between looks at a window that shows nothing
}

Navigator Viewer::StartOf(const Scene& scene, const Options& o)
{
  const Pose pose = MakePose(scene, o);
  return Navigator(pose.Eye, pose.Direction, pose.Up, o.Up.value_or(Vector3{ { 0, 1, 0 } }));
}

// Of no script, and no file that goes with the program.
std::string Viewer::ListOfRecent(const ViewerOptions& o)
{
  return o.Log.empty() && o.Frames == 0 && !o.HasStandardInput ? Recent::UsualFile() : "";
}

Viewer::Viewer(const ViewerOptions& options, std::optional<Loaded> scene, Room& room, Wall& windows,
  StateLog& log)
  : Given(options)
  , Opened(ListOfRecent(options))
  , Around(room)
  , Windows(windows)
  , Lines(log)
  , Now(options.Picture)
  , Angles(options.Picture)
  , Head({ { 0, 0, 0 } }, { { 0, 0, -1 } }, { { 0, 1, 0 } }, { { 0, 1, 0 } })
  , ShowsText(!options.NoText)
{
  this->At = windows.GetCursor();
  this->SetScene(scene ? std::move(*scene) : this->Read(this->Given.Picture, true));
  this->Now.View = this->Given.Picture.View; // that fits
  this->Angles = Fields(this->Given.Picture);
  this->Opened.Add(options.Picture.Files);
  this->Head = StartOf(this->What, this->Given.Picture);
  this->TakePose();
  if (options.Panel)
  {
    this->TogglePanel();
  }
}

bool Viewer::IsDone() const
{
  return this->Windows.IsClosing() ||
    (this->Given.Frames > 0 && this->Frames >= this->Given.Frames);
}

void Viewer::Run()
{
  while (!this->IsDone())
  {
    this->Wait();
    this->Windows.CheckAlive();
    const std::vector<WindowEvent> events = this->Windows.TakeEvents();
    const bool settled = this->LayOut(this->Dirty || !events.empty());
    for (const WindowEvent& event : events)
    {
      if (!this->IsForPanel(event))
      {
        this->Handle(event);
      }
    }
    if (this->Wanted)
    {
      this->Change(*std::exchange(this->Wanted, std::nullopt));
    }
    if (!this->WantedFiles.empty())
    {
      this->Open(std::exchange(this->WantedFiles, {}));
    }
    this->Play();
    this->PlayTime();
    this->Advance();
    this->Dirty = this->Windows.TakeDamage() || this->Dirty || this->Given.Frames > 0;
    this->Show();
    if (settled && this->Lines.IsOpen())
    {
      WaitForServer();
      this->Log("panel");
    }
  }
}

// What is to be seen now.
void Viewer::Show()
{
  if (this->Windows.IsClosing())
  {
    return;
  }
  if (this->Dirty && this->Fit())
  {
    this->DrawFrame();
  }
  else if (this->FlipsEyes())
  {
    this->Flip();
  }
  else if (this->Shown)
  {
    this->Windows.ShowAgain(*this->Shown);
  }
  this->Windows.RefreshPreview();
}

// One eye after the other, in windows that do not do it themselves.
bool Viewer::FlipsEyes() const
{
  const std::array<int, 2> size = this->Windows.GetSize();
  return ShowsEyesInTurn(this->Now) && !this->Windows.HasBuffersForBoth() && size == this->Now.Size;
}

void Viewer::Flip()
{
  const std::chrono::duration<double> period(1.0 / GlfwWindow::GetRefreshRate());
  const auto now = std::chrono::steady_clock::now();
  if (now - this->LastFlip >= period)
  {
    this->LastFlip = now;
    this->Windows.Flip(this->Shown.get());
  }
}

// Nothing to do, nothing done: an idle window costs no time.
void Viewer::Wait()
{
  const std::array<int, 2> size = this->Windows.GetSize();
  const bool hidden = size[0] <= 0 || size[1] <= 0;
  const bool moves = this->Dirty || !this->Held.empty() || this->Given.Frames > 0;
  const bool busy = moves || (this->Shown && this->Unsettled > 0);
  if (busy && hidden)
  {
    this->Windows.Wait(HiddenPause);
  }
  else if (busy)
  {
    this->Windows.Poll();
  }
  else
  {
    this->Windows.Wait(this->GetPatience());
  }
}

// Seconds until something is to be done that nobody has to ask for; below 0: nothing.
double Viewer::GetPatience() const
{
  double seconds = this->FlipsEyes() ? 1.0 / GlfwWindow::GetRefreshRate() : -1;
  if (const std::optional<double> pause = this->Around.GetPause(); pause && !this->Paused)
  {
    const double pose = std::min(*pause, LongestWait);
    seconds = seconds < 0 ? pose : std::min(seconds, pose);
  }
  if (const std::optional<double> pause =
        this->Time ? this->Time->GetPause(TimeLine::Clock::now()) : std::nullopt)
  {
    const double step = std::min(*pause, LongestWait);
    seconds = seconds < 0 ? step : std::min(seconds, step);
  }
  return seconds;
}

void Viewer::Advance()
{
  if (this->Held.empty())
  {
    return;
  }
  const auto now = std::chrono::steady_clock::now();
  const std::chrono::duration<double> passed = now - this->LastMove;
  this->LastMove = now;
  const double seconds = std::min(passed.count(), LongestMove);
  const double way = (this->Fast ? FasterFactor : 1) * seconds * this->SceneSize / FlightTime;
  Motion sum{ 0, 0, 0 };
  for (const int key : this->Held)
  {
    const Motion motion = *MotionOf(key);
    sum = { sum.Right + motion.Right, sum.Up + motion.Up, sum.Ahead + motion.Ahead };
  }
  this->Head.Fly(way * sum.Right, way * sum.Up, way * sum.Ahead);
  this->TakePose();
}

// The options for the window as it is. False where it shows nothing, or is larger than
// OpenGL can draw.
bool Viewer::Fit()
{
  const std::array<int, 2> size = this->Windows.GetSize();
  if (size[0] <= 0 || size[1] <= 0)
  {
    return false;
  }
  if (!this->Windows.IsWithinLimits())
  {
    this->Windows.CheckAlive(); // one that is gone may have any size
    this->Dirty = false;        // until it changes
    widefov::Say("warning: the window is larger than this OpenGL draws; make it smaller");
    return false;
  }
  if (size != this->Now.Size)
  {
    this->Now.Size = size;
    if (!this->Around.HasScreens())
    {
      this->Angles.Apply(this->Now);
      GiveUpTechnique(this->Now);
    }
  }
  return true;
}

void Viewer::DrawFrame()
{
  this->Dirty = false;
  this->Frames++;
  const bool moves = this->Dragging != Drag::None || !this->Held.empty();
  this->Windows.SetUpdateRate(moves ? this->Given.UpdateRate : 0);
  Extras extras;
  extras.Text = [this](const FrameCost& cost) { return this->TextFor(cost); };
  extras.Help = this->ShowsHelp ? HelpText() : "";
  extras.Cross = this->ShowsCrosshair ? &this->Cross : nullptr;
  extras.Pointer = this->Pointed();
  extras.Over = this->Shown.get();
  this->Cost = this->Windows.Draw(this->Parts(), extras);
  if (this->Lines.IsOpen())
  {
    WaitForServer(); // who reads of the frame finds it on the screen
    this->Log("frame");
  }
}

void Viewer::TakePose()
{
  this->Now.Eye = this->Head.GetEye();
  this->Now.LookAt.reset();
  this->Now.Direction = this->Head.GetDirection();
  this->Now.Up = this->Head.GetUp();
  this->Changed();
}

void Viewer::Say(const std::string& message)
{
  this->Message = message;
  this->Changed();
}

void Viewer::Handle(const WindowEvent& event)
{
  switch (event.What)
  {
    case WindowEvent::Kind::KeyPress:
    case WindowEvent::Kind::KeyRepeat:
    case WindowEvent::Kind::KeyRelease:
      this->HandleKey(event);
      break;
    case WindowEvent::Kind::ButtonPress:
    case WindowEvent::Kind::ButtonRelease:
      this->HandleButton(event);
      break;
    case WindowEvent::Kind::Cursor:
      this->HandleCursor({ event.Part, { { event.X, event.Y } } });
      break;
    case WindowEvent::Kind::Wheel:
      this->Zoom(event.Y);
      break;
    case WindowEvent::Kind::Drop:
      this->Open(event.Files);
      break;
  }
}

void Viewer::HandleKey(const WindowEvent& event)
{
  this->Fast = (event.Modifiers & GLFW_MOD_SHIFT) != 0;
  const bool press = event.What == WindowEvent::Kind::KeyPress;
  if (MotionOf(event.Code))
  {
    if (event.What == WindowEvent::Kind::KeyRelease)
    {
      this->Held.erase(event.Code);
      this->Sharpen();
      this->Log("release");
    }
    else if (press)
    {
      this->Message.clear();
      this->Held.insert(event.Code);
      this->LastMove = std::chrono::steady_clock::now() -
        std::chrono::duration_cast<std::chrono::steady_clock::duration>(
          std::chrono::duration<double>(FirstMove));
      this->Advance(); // a tap may be over before the next frame
    }
    return;
  }
  const std::optional<Action> action = ActionOf(event.Code, this->Fast);
  if (action && (press || (event.What == WindowEvent::Kind::KeyRepeat && Repeats(*action))))
  {
    this->Message.clear();
    this->Do(*action);
  }
}

void Viewer::HandleButton(const WindowEvent& event)
{
  const bool press = event.What == WindowEvent::Kind::ButtonPress;
  const Drag kind = event.Code == GLFW_MOUSE_BUTTON_LEFT ? Drag::Look
    : event.Code == GLFW_MOUSE_BUTTON_RIGHT              ? Drag::Orbit
                                                         : Drag::None;
  if (!press && kind == this->Dragging)
  {
    this->Dragging = Drag::None;
    this->Sharpen();
  }
  else if (press && this->Dragging == Drag::None)
  {
    const std::optional<Vector3> ray = this->RayUnderPointer();
    if (kind == Drag::Orbit || ray)
    {
      this->Dragging = kind;
    }
    this->Grip = ray ? this->Head.Grab(*ray) : this->Grip;
  }
  this->Log(press ? "press" : "release");
}

// Draws once more what was drawn coarser for it moved.
void Viewer::Sharpen()
{
  this->Dirty =
    this->Dirty || this->Cost.Coarse || (this->Cost.Draws && this->Cost.Draws->Relaxation > 0);
}

void Viewer::HandleCursor(const Place& at)
{
  const double right = at.At[0] - this->At.At[0];
  const double down = at.At[1] - this->At.At[1];
  this->At = at;
  if (this->Dragging == Drag::Look)
  {
    if (const std::optional<Vector3> ray = this->RayUnderPointer())
    {
      this->Head.Pull(this->Grip, *ray);
      this->TakePose();
    }
  }
  else if (this->Dragging == Drag::Orbit)
  {
    this->Head.Orbit(this->Center, -OrbitRate * right, OrbitRate * down);
    this->TakePose();
  }
  this->Dirty = this->Dirty || this->ShowsCrosshair;
}
}
