// SPDX-License-Identifier: BSD-3-Clause
#include "GlfwRenderWindow.h"

#include <vtkObjectFactory.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace widefov
{
vtkStandardNewMacro(GlfwRenderWindow);

void GlfwRenderWindow::SetWindow(GLFWwindow* window)
{
  this->Handle = window;
  this->MakeCurrent();
#if __has_include(<vtk_glad.h>)
  // since VTK 9.4, which loads OpenGL through the window system
  this->SetOpenGLSymbolLoader(
    [](void*, const char* name) -> VTKOpenGLAPIProc {
      return reinterpret_cast<VTKOpenGLAPIProc>(glfwGetProcAddress(name));
    },
    nullptr);
#endif
  this->OpenGLInit();
}

void GlfwRenderWindow::MakeCurrent()
{
  if (this->Handle != nullptr && !this->IsCurrent())
  {
    glfwMakeContextCurrent(this->Handle);
  }
}

bool GlfwRenderWindow::IsCurrent()
{
  return this->Handle != nullptr && glfwGetCurrentContext() == this->Handle;
}
}
