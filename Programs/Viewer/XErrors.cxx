// SPDX-License-Identifier: BSD-3-Clause
#include "XErrors.h"

#include "Text/Messages.h"

#include <cstdlib>
#include <unistd.h>

#define GLFW_INCLUDE_NONE
#define GLFW_EXPOSE_NATIVE_X11
#include <GLFW/glfw3.h>
#include <GLFW/glfw3native.h>

namespace widefov
{
namespace
{
int Forget(Display*, XErrorEvent*)
{
  return 0;
}

// Xlib ends the program when this returns, with a message of its own.
int Leave(Display*)
{
  LeaveAtOnce("the display is gone; start again where there is one");
}
}

void LeaveAtOnce(const std::string& message)
{
  Say(message);
  _exit(ExitFailed);
}

void HandleXErrors()
{
  XSetErrorHandler(Forget);
  XSetIOErrorHandler(Leave);
}

void WaitForServer()
{
  if (Display* const display = glfwGetX11Display())
  {
    XSync(display, False);
  }
}

bool WindowExists(GLFWwindow* window)
{
  Display* const display = glfwGetX11Display();
  if (display == nullptr)
  {
    return true;
  }
  XWindowAttributes attributes;
  return XGetWindowAttributes(display, glfwGetX11Window(window), &attributes) != 0;
}
}
