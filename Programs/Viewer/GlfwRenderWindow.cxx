// SPDX-License-Identifier: BSD-3-Clause
#include "GlfwRenderWindow.h"

#include <vtkObjectFactory.h>
#include <vtkOpenGLState.h>
#include <Gl.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace widefov
{
vtkStandardNewMacro(GlfwRenderWindow);

void GlfwRenderWindow::SetWindow(GLFWwindow* window, bool stereo)
{
  // VTK keeps a picture of each eye; without two back buffers they are shown by ShowEye
  this->SetStereoCapableWindow(1);
  this->TwoBuffers = stereo;
  if (stereo)
  {
    this->SetFrameBlitModeToBlitToHardware();
  }

  this->Handle = window;
  this->MakeCurrent();
#if WIDEFOV_LOADER_IS_GLAD
  this->SetOpenGLSymbolLoader(
    [](void*, const char* name) -> VTKOpenGLAPIProc {
      return reinterpret_cast<VTKOpenGLAPIProc>(glfwGetProcAddress(name));
    },
    nullptr);
#endif
  this->OpenGLInit();
}

void GlfwRenderWindow::ShowEye(int eye)
{
  this->MakeCurrent();
  vtkOpenGLState* const state = this->GetState();
  const int* const size = this->GetActualSize();
  state->PushFramebufferBindings();
  state->vtkglBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
  state->vtkglDrawBuffer(GL_BACK);
  this->BlitDisplayFramebuffer(
    eye, 0, 0, size[0], size[1], 0, 0, size[0], size[1], GL_COLOR_BUFFER_BIT, GL_NEAREST);
  state->PopFramebufferBindings();
}

void GlfwRenderWindow::DrawOver(const std::function<void()>& draw)
{
  this->MakeCurrent();
  vtkOpenGLState* const state = this->GetState();
  state->PushFramebufferBindings();
  state->vtkglBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
  state->vtkglDrawBuffer(GL_BACK);
  draw();
  state->PopFramebufferBindings();
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
