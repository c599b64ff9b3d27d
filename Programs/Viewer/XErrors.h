// SPDX-License-Identifier: BSD-3-Clause
// The X server behind GLFW: a window or a display may go away while it is used.
#ifndef WideFoVXErrors_h
#define WideFoVXErrors_h

#include <string>

struct GLFWwindow;

namespace widefov
{
// From here on an error that the X server reports is forgotten instead of fatal, and a
// server that is gone ends the program with one line and ExitFailed. GLFW sets handlers of
// its own now and then, so this is called again before each frame.
void HandleXErrors();

// Returns when the server has done all it was asked for.
void WaitForServer();

// Asks the server. True where the window system is not X.
bool WindowExists(GLFWwindow* window);

// Ends the program with ExitFailed and a message, without tidying up: Mesa's software renderers
// crash where the context of a window that is gone is to become current.
[[noreturn]] void LeaveAtOnce(const std::string& message);
}

#endif
