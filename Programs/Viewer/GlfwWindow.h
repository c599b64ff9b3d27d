// SPDX-License-Identifier: BSD-3-Clause
// A window of GLFW, and what happens to it.
#ifndef WideFoVGlfwWindow_h
#define WideFoVGlfwWindow_h

#include <array>
#include <memory>
#include <string>
#include <vector>

struct GLFWwindow;

namespace widefov
{
// Keys, buttons and modifiers are numbered as in GLFW. X and Y: of the cursor, pixels of the
// picture from its upper left corner; of the wheel, notches. A button has no place of its own,
// for where the pointer is when the event is handled is not where it was: it happened at the
// last place of the cursor before it.
struct WindowEvent
{
  enum class Kind
  {
    KeyPress,
    KeyRepeat,
    KeyRelease,
    ButtonPress,
    ButtonRelease,
    Cursor,
    Wheel,
    Drop
  };
  Kind What;
  int Code = 0; // key or button
  int Modifiers = 0;
  double X = 0;
  double Y = 0;
  unsigned long Order = 0;             // among the events of all windows
  std::size_t Part = 0;                // of what several windows show (Wall.h)
  std::vector<std::string> Files = {}; // that were dropped
};

class GlfwWindow
{
public:
  // Throws a Failure with ExitFailed: no OpenGL 3.2, no such monitor (from 1; 0 is the
  // primary one; asked for full screens alone). stereo: with a back buffer for each eye, where
  // the display has such windows.
  GlfwWindow(const std::string& title, const std::array<int, 2>& size, bool fullScreen, int monitor,
    bool stereo = false);
  ~GlfwWindow();
  GlfwWindow(const GlfwWindow&) = delete;
  GlfwWindow& operator=(const GlfwWindow&) = delete;

  GLFWwindow* GetHandle() const { return this->Handle; }

  // Handles what has happened to all windows: returns at once, or waits for something to
  // happen (at most so many seconds; below 0: as long as it takes).
  static void Poll();
  static void Wait(double seconds = -1);

  void SetTitle(const std::string& title);

  // Moves the window so many pixels to the right of and below another one.
  void PlaceBeside(const GlfwWindow& other, int right, int below);

  // What happened since the last call, in order.
  std::vector<WindowEvent> TakeEvents();

  // True once after what is shown was damaged or changed its size.
  bool TakeDamage();

  // True where there is a back buffer for each eye.
  bool IsStereo() const { return this->Stereo; }

  static int CountMonitors();

  // The system's own pointer.
  void SetPointerShown(bool shown);

  // Pictures that the monitor shows in a second.
  static int GetRefreshRate();

  bool IsClosing() const;
  void Close();

  // Ends the program where the window was destroyed from outside.
  void CheckAlive() const;

  // Width and height of the picture in pixels; 0 where nothing can be seen of it.
  std::array<int, 2> GetSize() const;

  // Where the pointer is, pixels of the picture.
  std::array<double, 2> GetCursor() const;

  bool IsFullScreen() const;
  void SetFullScreen(bool on);
  void NextMonitor(); // full screen

  void Show(); // what was drawn

private:
  friend struct GlfwCallbacks;
  void EnterMonitor(int index);
  std::array<double, 2> ToPixels(double x, double y) const;

  GLFWwindow* Handle = nullptr;
  std::vector<WindowEvent> Events;
  bool Damaged = true;
  bool Stereo = false;
  int Monitor = 0;                             // index
  std::array<int, 4> Before{ { 0, 0, 0, 0 } }; // place and size outside the full screen
};
}

#endif
