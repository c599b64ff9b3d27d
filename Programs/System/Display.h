// SPDX-License-Identifier: BSD-3-Clause
// Is there a display, and what can its OpenGL do?
#ifndef WideFoVDisplay_h
#define WideFoVDisplay_h

#include "vtkWideFoVAbi.h"

#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkRenderWindow;
VTK_ABI_NAMESPACE_END

namespace widefov
{
// A connection to the display, checked before VTK's own, which would abort the program.
// Keep it while there are windows: an X server starts anew when its last client leaves,
// and refuses others meanwhile.
class DisplayConnection
{
public:
  // Throws a Failure with ExitFailed where no display can be opened and VTK needs one; where it
  // needs none, there is no connection.
  DisplayConnection();
  ~DisplayConnection();
  DisplayConnection(const DisplayConnection&) = delete;
  DisplayConnection& operator=(const DisplayConnection&) = delete;

private:
  void* Connection = nullptr;
};

// Opens a small off-screen window. Throws a Failure with ExitFailed where OpenGL is older
// than 3.2, which brought geometry shaders.
void OpenWindow(vtkRenderWindow* window);

struct GlLimits
{
  int Width = 0; // pixels
  int Height = 0;
  int Samples = 0;
};

// Of an open window.
GlLimits QueryLimits(vtkRenderWindow* window);

struct GlStrings
{
  std::string Vendor;
  std::string Renderer;
  std::string Version;
};

GlStrings QueryStrings(vtkRenderWindow* window);
}

#endif
