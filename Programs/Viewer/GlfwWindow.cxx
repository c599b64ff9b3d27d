// SPDX-License-Identifier: BSD-3-Clause
#include "GlfwWindow.h"

#include "System/CrashGuard.h"
#include "Text/Messages.h"
#include "XErrors.h"

#include <algorithm>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace widefov
{
namespace
{
constexpr int LargestWindow = 32767; // pixels, of the X protocol

std::string LastError;
int WindowCount = 0;

void KeepError(int, const char* text)
{
  LastError = text;
}

std::string TakeError()
{
  std::string error;
  error.swap(LastError);
  return error.empty() ? "" : " (" + OneLine(error) + ")";
}

// GLFW ends with its last window.
void Terminate()
{
  if (WindowCount == 0)
  {
    glfwTerminate();
  }
}

std::vector<GLFWmonitor*> Monitors()
{
  int count = 0;
  GLFWmonitor** const monitors = glfwGetMonitors(&count);
  return std::vector<GLFWmonitor*>(monitors, monitors + count);
}

void Initialize()
{
  if (WindowCount > 0)
  {
    return;
  }
  glfwSetErrorCallback(KeepError);
  if (glfwInit() != GLFW_TRUE)
  {
    Fail("no window can be made here" + TakeError() + "; check the display");
  }
}

// stereo: on return, whether the window has two back buffers.
GLFWwindow* Create(const std::string& title, const std::array<int, 2>& size, bool& stereo)
{
  const std::string tooOld = "OpenGL 3.2 with geometry shaders is needed";
  const std::string remedy = "; update the graphics driver, or use Mesa's software rendering";
  const CrashGuard guard(tooOld + ", and opening a window here crashed" + remedy);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 2);
  // not forward compatible: such contexts refuse lines wider than a pixel
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_AUTO_ICONIFY, GLFW_FALSE); // a wall's screens stay lit
  // the limits of OpenGL, which are narrower, can be asked for when there is a window
  const int width = std::min(size[0], LargestWindow);
  const int height = std::min(size[1], LargestWindow);
  glfwWindowHint(GLFW_STEREO, stereo ? GLFW_TRUE : GLFW_FALSE);
  GLFWwindow* window = glfwCreateWindow(width, height, title.c_str(), nullptr, nullptr);
  if (window == nullptr && stereo)
  {
    stereo = false;
    TakeError();
    glfwWindowHint(GLFW_STEREO, GLFW_FALSE);
    window = glfwCreateWindow(width, height, title.c_str(), nullptr, nullptr);
  }
  if (window == nullptr)
  {
    const std::string error = TakeError();
    Terminate();
    Fail(tooOld + ", but no such window could be opened" + error + remedy);
  }
  glfwMakeContextCurrent(window);
  glfwSwapInterval(1);
  return window;
}
}

// What GLFW calls: it only takes notes, so that nothing is thrown through C.
struct GlfwCallbacks
{
  static GlfwWindow& Of(GLFWwindow* handle)
  {
    return *static_cast<GlfwWindow*>(glfwGetWindowUserPointer(handle));
  }

  static void Note(GLFWwindow* handle, WindowEvent event)
  {
    static unsigned long noted = 0;
    event.Order = ++noted;
    Of(handle).Events.push_back(event);
  }

  static void Key(GLFWwindow* handle, int key, int, int action, int modifiers)
  {
    const WindowEvent::Kind kind = action == GLFW_PRESS ? WindowEvent::Kind::KeyPress
      : action == GLFW_REPEAT                           ? WindowEvent::Kind::KeyRepeat
                                                        : WindowEvent::Kind::KeyRelease;
    Note(handle, { kind, key, modifiers });
  }

  static void Button(GLFWwindow* handle, int button, int action, int modifiers)
  {
    const WindowEvent::Kind kind =
      action == GLFW_PRESS ? WindowEvent::Kind::ButtonPress : WindowEvent::Kind::ButtonRelease;
    Note(handle, { kind, button, modifiers });
  }

  static void Cursor(GLFWwindow* handle, double x, double y)
  {
    const std::array<double, 2> at = Of(handle).ToPixels(x, y);
    Note(handle, { WindowEvent::Kind::Cursor, 0, 0, at[0], at[1] });
  }

  static void Wheel(GLFWwindow* handle, double x, double y)
  {
    Note(handle, { WindowEvent::Kind::Wheel, 0, 0, x, y });
  }

  static void Drop(GLFWwindow* handle, int count, const char** paths)
  {
    WindowEvent event{ WindowEvent::Kind::Drop };
    event.Files.assign(paths, paths + count);
    Note(handle, event);
  }

  static void Resize(GLFWwindow* handle, int, int) { Of(handle).Damaged = true; }

  static void Damage(GLFWwindow* handle) { Of(handle).Damaged = true; }
};

GlfwWindow::GlfwWindow(const std::string& title, const std::array<int, 2>& size, bool fullScreen,
  int monitor, bool stereo)
  : Stereo(stereo)
{
  Initialize();
  const int count = CountMonitors();
  if (monitor > count && fullScreen)
  {
    Terminate();
    Fail("there is no monitor " + std::to_string(monitor) + ", only " + std::to_string(count) +
      "; choose another --monitor, or leave --full-screen out of a --wall or --screens");
  }
  this->Handle = Create(title, size, this->Stereo);
  WindowCount++;
  this->Monitor = monitor > 0 ? monitor - 1 : 0;
  glfwSetWindowUserPointer(this->Handle, this);
  glfwSetKeyCallback(this->Handle, GlfwCallbacks::Key);
  glfwSetMouseButtonCallback(this->Handle, GlfwCallbacks::Button);
  glfwSetCursorPosCallback(this->Handle, GlfwCallbacks::Cursor);
  glfwSetScrollCallback(this->Handle, GlfwCallbacks::Wheel);
  glfwSetDropCallback(this->Handle, GlfwCallbacks::Drop);
  glfwSetFramebufferSizeCallback(this->Handle, GlfwCallbacks::Resize);
  glfwSetWindowRefreshCallback(this->Handle, GlfwCallbacks::Damage);
  this->SetFullScreen(fullScreen);
  HandleXErrors();
}

GlfwWindow::~GlfwWindow()
{
  glfwDestroyWindow(this->Handle);
  HandleXErrors(); // the window may not be there any more
  WindowCount--;
  Terminate();
}

void GlfwWindow::Poll()
{
  glfwPollEvents();
  HandleXErrors();
}

void GlfwWindow::Wait(double seconds)
{
  if (seconds < 0)
  {
    glfwWaitEvents();
  }
  else
  {
    glfwWaitEventsTimeout(seconds);
  }
  HandleXErrors();
}

void GlfwWindow::SetTitle(const std::string& title)
{
  glfwSetWindowTitle(this->Handle, title.c_str());
}

void GlfwWindow::PlaceBeside(const GlfwWindow& other, int right, int below)
{
  int x = 0;
  int y = 0;
  glfwGetWindowPos(other.Handle, &x, &y);
  glfwSetWindowPos(this->Handle, x + right, y + below);
}

std::vector<WindowEvent> GlfwWindow::TakeEvents()
{
  std::vector<WindowEvent> events;
  events.swap(this->Events);
  return events;
}

bool GlfwWindow::TakeDamage()
{
  const bool damaged = this->Damaged;
  this->Damaged = false;
  return damaged;
}

int GlfwWindow::CountMonitors()
{
  return static_cast<int>(Monitors().size());
}

void GlfwWindow::SetPointerShown(bool shown)
{
  glfwSetInputMode(this->Handle, GLFW_CURSOR, shown ? GLFW_CURSOR_NORMAL : GLFW_CURSOR_HIDDEN);
}

int GlfwWindow::GetRefreshRate()
{
  constexpr int Usual = 60;
  GLFWmonitor* const monitor = glfwGetPrimaryMonitor();
  const GLFWvidmode* const mode = monitor != nullptr ? glfwGetVideoMode(monitor) : nullptr;
  return mode != nullptr && mode->refreshRate > 0 ? mode->refreshRate : Usual;
}

bool GlfwWindow::IsClosing() const
{
  return glfwWindowShouldClose(this->Handle) != 0;
}

void GlfwWindow::Close()
{
  glfwSetWindowShouldClose(this->Handle, GLFW_TRUE);
}

void GlfwWindow::CheckAlive() const
{
  if (!WindowExists(this->Handle))
  {
    LeaveAtOnce("the window was destroyed by another program; start again");
  }
}

std::array<int, 2> GlfwWindow::GetSize() const
{
  if (glfwGetWindowAttrib(this->Handle, GLFW_ICONIFIED) != 0)
  {
    return { { 0, 0 } };
  }
  std::array<int, 2> size{ { 0, 0 } };
  glfwGetFramebufferSize(this->Handle, &size[0], &size[1]);
  return size;
}

std::array<double, 2> GlfwWindow::ToPixels(double x, double y) const
{
  int width = 0;
  int height = 0;
  glfwGetWindowSize(this->Handle, &width, &height);
  int pixels[2] = { 0, 0 };
  glfwGetFramebufferSize(this->Handle, &pixels[0], &pixels[1]);
  // the pointer is at the middle of a pixel
  return { { (x + 0.5) * pixels[0] / std::max(1, width),
    (y + 0.5) * pixels[1] / std::max(1, height) } };
}

std::array<double, 2> GlfwWindow::GetCursor() const
{
  double x = 0;
  double y = 0;
  glfwGetCursorPos(this->Handle, &x, &y);
  return this->ToPixels(x, y);
}

bool GlfwWindow::IsFullScreen() const
{
  return glfwGetWindowMonitor(this->Handle) != nullptr;
}

void GlfwWindow::EnterMonitor(int index)
{
  const std::vector<GLFWmonitor*> monitors = Monitors();
  if (monitors.empty())
  {
    return; // the last one was unplugged
  }
  if (!this->IsFullScreen())
  {
    glfwGetWindowPos(this->Handle, &this->Before[0], &this->Before[1]);
    glfwGetWindowSize(this->Handle, &this->Before[2], &this->Before[3]);
  }
  this->Monitor = index % static_cast<int>(monitors.size());
  GLFWmonitor* const monitor = monitors[static_cast<std::size_t>(this->Monitor)];
  const GLFWvidmode* const mode = glfwGetVideoMode(monitor);
  if (mode != nullptr)
  {
    glfwSetWindowMonitor(this->Handle, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
  }
}

void GlfwWindow::SetFullScreen(bool on)
{
  if (on)
  {
    this->EnterMonitor(this->Monitor);
  }
  else if (this->IsFullScreen())
  {
    glfwSetWindowMonitor(this->Handle, nullptr, this->Before[0], this->Before[1], this->Before[2],
      this->Before[3], GLFW_DONT_CARE);
  }
  this->Damaged = true;
}

void GlfwWindow::NextMonitor()
{
  this->EnterMonitor(this->IsFullScreen() ? this->Monitor + 1 : this->Monitor);
  this->Damaged = true;
}

void GlfwWindow::Show()
{
  glfwSwapBuffers(this->Handle);
}
}
