// SPDX-License-Identifier: BSD-3-Clause
// What the viewer reads while its window is open, and the list of poses that it writes.
#include "Loader.h"
#include "Pictures/CameraSetup.h"
#include "Text/Messages.h"
#include "Viewer.h"
#include "Viewing/CommandText.h"
#include "Viewing/PoseList.h"
#include "Viewing/Session.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <new>
#include <utility>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace widefov
{
namespace
{
using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds Glance{ 30 }; // between looks at the window
constexpr double Unnoticed = 0.2;                 // seconds for which nothing is said

constexpr const char* UsualSession = "widefov-viewer-session.conf";

std::string ProgressText(const std::string& what, double seconds)
{
  char time[64];
  std::snprintf(time, sizeof(time), "%.1f s, Q quits", seconds);
  return "reading " + what + "\n" + time;
}

bool Quits(const WindowEvent& event)
{
  const std::optional<Action> action = event.What == WindowEvent::Kind::KeyPress
    ? ActionOf(event.Code, (event.Modifiers & GLFW_MOD_SHIFT) != 0)
    : std::nullopt;
  return action == Action::Quit || action == Action::Leave;
}
}

Loaded Viewer::Read(Options& options, bool fits)
{
  if (this->Given.HasStandardInput || !TakesLong(options))
  {
    return LoadFitted(options, fits);
  }
  const auto read = std::make_shared<std::pair<Options, Loaded>>(options, Loaded());
  this->ReadBeside(NameOf(options), [read, fits] { read->second = LoadFitted(read->first, fits); });
  options = read->first;
  return read->second;
}

// The window goes on being moved, made larger and closed; what is in it stays as it was. Who leaves
// then leaves no time to remove what standard input was written to.
void Viewer::ReadBeside(const std::string& what, const std::function<void()>& work)
{
  Loader loader(work);
  std::unique_ptr<Panel> own;
  this->Windows.SetTitle("reading " + what);
  const Clock::time_point start = Clock::now();
  while (!loader.Wait(Glance))
  {
    const std::chrono::duration<double> passed = Clock::now() - start;
    if (!this->Shown && !own && passed.count() > Unnoticed)
    {
      own = this->Windows.MakePanel();
    }
    Panel* const over = own ? own.get() : this->Shown.get();
    if (over != nullptr && passed.count() > Unnoticed)
    {
      over->LayoutText(ProgressText(what, passed.count()));
      this->Windows.ShowAgain(*over);
    }
    this->AttendWhileReading();
  }
  this->Held.clear(); // what was let go meanwhile was not heard
  this->Dragging = Drag::None;
  this->Unsettled = LayoutsToSettle; // of the widgets, in the place of these lines
  this->Changed();
  loader.Finish();
}

void Viewer::AttendWhileReading()
{
  this->Windows.Poll();
  this->Windows.CheckAlive();
  bool quits = this->Windows.IsClosing();
  for (const WindowEvent& event : this->Windows.TakeEvents())
  {
    quits = quits || Quits(event);
  }
  if (quits)
  {
    std::fflush(nullptr);
    std::_Exit(ExitDone); // a reader cannot be interrupted, and uses what an exit takes down
  }
}

void Viewer::SetScene(Loaded loaded)
{
  const bool plays = this->Time && this->Time->IsPlaying();
  this->What = std::move(loaded.What);
  this->Time.reset();
  if (loaded.Steps)
  {
    this->Time = std::make_unique<TimeLine>(std::move(loaded.Steps), this->Given.TimeRate);
    this->Time->Play(plays, TimeLine::Clock::now());
  }
  double b[6];
  if (SceneBounds(this->What, b))
  {
    this->Center = { { 0.5 * (b[0] + b[1]), 0.5 * (b[2] + b[3]), 0.5 * (b[4] + b[5]) } };
    const double size = std::hypot(b[1] - b[0], b[3] - b[2], b[5] - b[4]);
    this->SceneSize = size > 0 ? size : 1;
  }
  this->Windows.SetScene(this->What, this->Given.Picture.Look);
  this->Windows.SetTitle(NameOf(this->Given.Picture));
  this->Cross = Aim();
  this->Changed();
}

// Reads other data, or the same for another look. What cannot be read is said, and leaves all as
// it was.
bool Viewer::Change(Options options)
{
  try
  {
    const bool other = options.Files != this->Given.Picture.Files;
    Loaded loaded = this->Read(options, other);
    const Navigator start = StartOf(loaded.What, options);
    this->Given.Picture = options;
    this->Now.Look = options.Look;
    this->SetScene(std::move(loaded));
    if (other)
    {
      this->Head = start;
      this->Now.HasClip = options.HasClip;
      this->Now.View.Stereo.InterpupillaryDistance = options.View.Stereo.InterpupillaryDistance;
      this->Angles = Fields(options);
      this->Angles.Apply(this->Now);
      this->TakePose();
    }
    return true;
  }
  catch (const Failure& failure)
  {
    widefov::SayError(failure.what());
    this->Say(failure.what());
  }
  catch (const std::bad_alloc&)
  {
    widefov::SayError("there is not enough memory for " + NameOf(options) + "; open smaller data");
    this->Say("there is not enough memory for these data");
  }
  this->Windows.SetTitle(NameOf(this->Given.Picture));
  return false;
}

// What was said of the data before is not true of these: places and names of arrays.
void Viewer::Open(const std::vector<std::string>& files)
{
  Options next = this->Given.Picture;
  next.Files = files;
  next.Scene.clear();
  next.Time.reset();
  next.Look.ColorBy.clear();
  next.Look.Vectors.clear();
  next.Look.StreamLines.clear();
  next.Look.Range.reset();
  next.Eye.reset();
  next.LookAt.reset();
  next.Direction.reset();
  next.View = this->Given.Asked.View;
  next.HasClip = false;
  if (this->Change(next))
  {
    this->Opened.Add(files);
    this->Say("opened: " + NameOf(next));
  }
}

void Viewer::AddPose()
{
  try
  {
    const std::size_t number = AppendPose(
      this->Given.PoseList, this->Head.GetEye(), this->Head.GetDirection(), this->Head.GetUp());
    this->Say("pose " + std::to_string(number) + " of " + this->Given.PoseList);
  }
  catch (const Failure& failure)
  {
    widefov::SayError(failure.what()); // no reason to lose the view
    this->Say(failure.what());
  }
}

void Viewer::SaveSession()
{
  try
  {
    if (this->Given.HasStandardInput)
    {
      Fail("what came from standard input cannot be kept in a session; write it to a file first");
    }
    Options now = this->ForFiles();
    now.Layout = this->Now.Layout;
    std::vector<Setting> settings = SettingsOf(this->Given.Picture, now);
    settings.push_back({ "--poses", this->Given.PoseList, "" });
    for (const auto& [flag, on] : { std::pair("--full-screen", this->Windows.IsFullScreen()),
           std::pair("--no-text", !this->ShowsText), std::pair("--panel", this->Shown != nullptr) })
    {
      settings.push_back({ flag, on ? "yes" : "no", "" });
    }
    const std::string path = this->Given.Session.empty() ? UsualSession : this->Given.Session;
    WriteSession(path, settings);
    this->Say("saved: " + path);
  }
  catch (const Failure& failure)
  {
    widefov::SayError(failure.what()); // no reason to lose the view
    this->Say(failure.what());
  }
}
}
