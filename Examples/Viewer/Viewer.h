// SPDX-License-Identifier: BSD-3-Clause
// What the user does, and what is shown for it.
#ifndef WideFoVViewer_h
#define WideFoVViewer_h

#include "Fields.h"
#include "Keys.h"
#include "Navigator.h"
#include "Room.h"
#include "Scene.h"
#include "StateLog.h"
#include "ViewerOptions.h"
#include "Wall.h"

#include <chrono>
#include <set>

namespace widefov
{
class Viewer
{
public:
  // All of them must outlive this.
  Viewer(
    const ViewerOptions& options, const Scene& scene, Room& room, Wall& windows, StateLog& log);

  // Until the window is closed, or so many frames are drawn. Throws a Failure with
  // ExitFailed.
  void Run();

private:
  enum class Drag
  {
    None,
    Look,
    Orbit
  };

  // The loop.
  void Wait();
  double GetPatience() const;
  bool FlipsEyes() const;
  void Flip();
  void Play();
  void Advance();
  bool Fit();
  void DrawFrame();
  bool IsDone() const;

  // What happens.
  void Handle(const WindowEvent& event);
  void HandleKey(const WindowEvent& event);
  void HandleButton(const WindowEvent& event);
  void HandleCursor(const Place& at);
  void Do(Action action);
  bool DoView(Action action);
  bool DoHead(Action action);
  bool StepEyes(Action action);
  bool StepScreens(Action action);
  void Zoom(double notches);
  void ZoomRoom(double factor);
  void ToggleCrosshair();
  void TogglePause();
  void Leave();
  void TakeScreenshot();
  void Restart();

  // The view.
  static Navigator StartOf(const Scene& scene, const Options& options);
  void TakePose();
  std::vector<Options> Parts() const;
  Options ForFiles() const;
  Place Pointed() const;
  std::optional<Vector3> RayUnderPointer() const;
  void Sharpen();
  void Changed() { this->Dirty = true; }
  void Say(const std::string& message);
  std::string TextFor(const FrameCost& cost) const;
  void Log(const std::string& event);

  const ViewerOptions& Given;
  const Scene& What;
  Room& Around;
  Wall& Windows;
  StateLog& Lines;

  Options Now; // what is drawn
  Fields Angles;
  Navigator Head;
  Vector3 Center{ { 0, 0, 0 } }; // of the scene
  double SceneSize = 1;          // scene units

  bool Dirty = true;
  long long Frames = 0;
  FrameCost Cost;
  std::string Message;
  bool ShowsText = true;
  bool ShowsHelp = false;

  Drag Dragging = Drag::None;
  Place At; // the pointer
  bool ShowsCrosshair = false;
  Aim Cross;
  Navigator::Grip Grip;
  std::set<int> Held; // keys that move the eye
  bool Fast = false;
  std::chrono::steady_clock::time_point LastMove;
  std::chrono::steady_clock::time_point LastFlip;
  std::chrono::steady_clock::time_point LastPose;
  bool Paused = false; // the head poses
};
}

#endif
