// SPDX-License-Identifier: BSD-3-Clause
// What the user does, and what is shown for it.
#ifndef WideFoVViewer_h
#define WideFoVViewer_h

#include "Loader.h"
#include "Panel.h"
#include "Scenes/Scene.h"
#include "StateLog.h"
#include "ViewerOptions.h"
#include "Viewing/Fields.h"
#include "Viewing/Keys.h"
#include "Viewing/Navigator.h"
#include "Viewing/Recent.h"
#include "Viewing/Room.h"
#include "Viewing/TimeLine.h"
#include "Wall.h"

#include <array>
#include <chrono>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace widefov
{
class Viewer
{
public:
  // Without a scene the data are read first, beside the window; then this throws what LoadScene
  // throws. The room, the windows and the log must outlive this.
  Viewer(const ViewerOptions& options, std::optional<Loaded> scene, Room& room, Wall& windows,
    StateLog& log);

  // Until the window is closed, or so many frames are drawn. Throws a Failure with
  // ExitFailed.
  void Run();

private:
  static constexpr int LayoutsToSettle = 6; // of the panel, for what follows from an event

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
  void Show();
  void DrawFrame();
  bool IsDone() const;

  // Data. As LoadFitted, beside the window where it takes long.
  Loaded Read(Options& options, bool fits);
  void ReadBeside(const std::string& what, const std::function<void()>& work);
  void AttendWhileReading();
  void SetScene(Loaded loaded);
  bool Change(Options options);
  static std::string ListOfRecent(const ViewerOptions& options);
  void Open(const std::vector<std::string>& files);
  void AddPose();
  void SaveSession();

  // Time.
  void PlayTime();
  void ShowStep(std::size_t step);
  bool StepTime(Action action);
  void TogglePlay();
  std::string TextOfTime() const;

  // The panel.
  void TogglePanel();
  bool LayOut(bool happened);
  bool IsForPanel(const WindowEvent& event) const;
  void Widgets();
  void ChooseView();
  void ChooseAngles();
  void ChooseEyes();
  bool ChooseNumbers(wfv::StereoOptions& stereo);
  void ChooseLook();
  void ChooseFile();
  void ChooseTime();
  void ChooseRest();
  bool Choose(const std::string& what, std::string& value, const std::vector<std::string>& from);
  bool Slide(const std::string& what, double& value, double least, double most);
  void ChooseOpacity();
  void ChoosePreset();
  void Press(const char* label, Action action);
  void Check(const char* label, bool on, Action action);
  void Locate(const std::string& widget);

  // What happens.
  void Handle(const WindowEvent& event);
  void HandleKey(const WindowEvent& event);
  void HandleButton(const WindowEvent& event);
  void HandleCursor(const Place& at);
  void Do(Action action);
  void DoWindow(Action action);
  bool DoText(Action action);
  bool DoView(Action action);
  bool DoHead(Action action);
  bool StepEyes(Action action);
  bool StepScreens(Action action);
  void Zoom(double notches);
  void ZoomBy(double factor);
  void ZoomRoom(double factor);
  void ToggleCrosshair();
  void NextPreview();
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

  ViewerOptions Given;
  Scene What;
  std::unique_ptr<TimeLine> Time;    // of data that change
  Recent Opened;                     // files
  std::vector<std::string> Recently; // when the panel was shown
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
  bool ShowsNumbers = false; // what a frame took
  bool ShowsHelp = false;
  std::unique_ptr<Panel> Shown;                        // widgets
  int Unsettled = 0;                                   // layouts until it shows what happened
  std::map<std::string, std::array<double, 4>> Places; // of widgets: left, top, right, bottom
  std::array<double, 4> PanelArea{ { 0, 0, 0, 0 } };   // the same of the panel
  bool HasPopup = false;                               // a list of it is open
  std::vector<Action> Pressed;                         // on the panel
  std::optional<Options> Wanted;                       // that the data are to be read for
  std::vector<std::string> WantedFiles;                // that are to be opened
  std::optional<std::size_t> WantedStep;               // of time

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
