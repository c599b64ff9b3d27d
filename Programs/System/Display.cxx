// SPDX-License-Identifier: BSD-3-Clause
#include "Display.h"

#include "Compat/WindowsAnywhere.h"
#include "CrashGuard.h"
#include "MessageCatcher.h"
#include "Text/Messages.h"

#include <vtkOpenGLRenderWindow.h>
#include <Gl.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <thread>

#include <X11/Xlib.h>

namespace widefov
{
namespace
{
// A server that starts anew after its last client left is back within this.
constexpr int Attempts = 5;
constexpr std::chrono::milliseconds Pause{ 50 };

std::string GlString(GLenum name)
{
  const GLubyte* const text = glGetString(name);
  return text != nullptr ? reinterpret_cast<const char*>(text) : "";
}
}

DisplayConnection::DisplayConnection()
{
  const char* const name = std::getenv("DISPLAY");
  const bool named = name != nullptr && *name != '\0';
  for (int i = 0; named && i < Attempts && this->Connection == nullptr; i++)
  {
    std::this_thread::sleep_for(i * Pause);
    const QuietStandardError quiet;
    this->Connection = XOpenDisplay(nullptr);
  }
  if (this->Connection != nullptr)
  {
    return;
  }
  if (wfv::compat::WindowsNeedADisplay)
  {
    Fail((named ? "the display " + std::string(name) + " cannot be opened"
                : std::string("there is no display (DISPLAY is not set)")) +
      "; without a screen, run it as: xvfb-run -a " + GetProgramName() + " ...");
  }
  setenv(wfv::compat::WindowVariable, wfv::compat::WindowWithoutDisplay, 0);
}

DisplayConnection::~DisplayConnection()
{
  if (this->Connection != nullptr)
  {
    XCloseDisplay(static_cast<Display*>(this->Connection));
  }
}

void OpenWindow(vtkRenderWindow* window)
{
  const std::string tooOld = "OpenGL 3.2 with geometry shaders is needed";
  const std::string remedy = "; update the graphics driver, or use Mesa's software rendering";
  const QuietStandardError quiet;
  const CrashGuard guard(tooOld + ", and opening a window here crashed" + remedy);
  window->SetOffScreenRendering(1);
  window->SetSize(16, 16);
  vtkOpenGLRenderWindow* const gl = vtkOpenGLRenderWindow::SafeDownCast(window);
  int major = 0;
  int minor = 0;
  if (gl != nullptr)
  {
    gl->Initialize();
    gl->GetOpenGLVersion(major, minor);
  }
  const std::string error = MessageCatcher::TakeFirstError();
  if (major < 3 || (major == 3 && minor < 2))
  {
    Fail(tooOld +
      (major > 0 ? ", but this display has " + std::to_string(major) + "." + std::to_string(minor)
                 : ", but no window could be opened" + (error.empty() ? "" : " (" + error + ")")) +
      remedy);
  }
}

GlLimits QueryLimits(vtkRenderWindow* window)
{
  window->MakeCurrent();
  GLint viewport[2] = { 0, 0 };
  GLint texture = 0;
  GLint buffer = 0;
  GlLimits limits;
  glGetIntegerv(GL_MAX_VIEWPORT_DIMS, viewport);
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &texture);
  glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &buffer);
  glGetIntegerv(GL_MAX_SAMPLES, &limits.Samples);
  limits.Width = std::min({ viewport[0], texture, buffer });
  limits.Height = std::min({ viewport[1], texture, buffer });
  return limits;
}

GlStrings QueryStrings(vtkRenderWindow* window)
{
  window->MakeCurrent();
  return { GlString(GL_VENDOR), GlString(GL_RENDERER), GlString(GL_VERSION) };
}
}
