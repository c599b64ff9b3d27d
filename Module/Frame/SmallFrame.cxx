// SPDX-License-Identifier: BSD-3-Clause
#include "Frame/SmallFrame.h"

#include "Compat/Gl.h"
#include "WideFoVGlsl.h"

#include "vtkOpenGLCamera.h"
#include "vtkOpenGLQuadHelper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <algorithm>

namespace
{
constexpr int DepthBits = 24; // as VTK's own framebuffers have

bool ShowsTile(vtkRenderWindow* window)
{
  double t[4];
  window->GetTileViewport(t);
  return t[0] > 0 || t[1] > 0 || t[2] < 1 || t[3] < 1;
}

void Filter(vtkTextureObject* texture, int filter)
{
  texture->SetMinificationFilter(filter);
  texture->SetMagnificationFilter(filter);
  texture->SetWrapS(vtkTextureObject::ClampToEdge);
  texture->SetWrapT(vtkTextureObject::ClampToEdge);
}
}

namespace wfv
{
SmallFrame::SmallFrame() = default;

SmallFrame::~SmallFrame() = default;

bool SmallFrame::IsPossible(const vtkRenderState* s) const
{
  vtkRenderer* const renderer = s->GetRenderer();
  auto* const window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  return window && !this->Fails && !s->GetFrameBuffer() && !renderer->GetSelector() &&
    !ShowsTile(window) && !window->GetUseSRGBColorSpace() && window->GetErase() &&
    renderer->GetErase() && !renderer->Transparent() && !renderer->GetPreserveDepthBuffer();
}

void SmallFrame::Shrink(vtkRenderer* renderer, int factor)
{
  this->Renderer = renderer;
  this->Window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  renderer->GetViewport(this->Viewport);
  int origin[2];
  renderer->GetTiledSizeAndOrigin(&this->Size[0], &this->Size[1], &origin[0], &origin[1]);
  const int* const all = this->Window->GetSize();
  double share[2];
  for (int i = 0; i < 2; i++)
  {
    this->Size[i] = std::max(1, (this->Size[i] + factor - 1) / factor);
    share[i] = static_cast<double>(this->Size[i]) / std::max(1, all[i]);
  }
  renderer->SetViewport(0, 0, share[0], share[1]);
}

void SmallFrame::Allocate()
{
  const bool same = this->Framebuffer->GetContext() == this->Window;
  if (!same || !std::equal(this->Size, this->Size + 2, this->Allocated))
  {
    this->ReleaseGraphicsResources(this->Framebuffer->GetContext());
    this->Framebuffer->SetContext(this->Window);
    this->Framebuffer->PopulateFramebuffer(this->Size[0], this->Size[1], true, 1, VTK_UNSIGNED_CHAR,
      true, DepthBits, 0, this->Window->GetStencilCapable() != 0);
    std::copy_n(this->Size, 2, this->Allocated);
  }
  this->Framebuffer->Bind();
  this->Framebuffer->ActivateDrawBuffer(0);
  this->Framebuffer->ActivateReadBuffer(0);
}

void SmallFrame::Begin()
{
  vtkOpenGLState* const state = this->Window->GetState();
  state->PushFramebufferBindings();
  this->Allocate();
  // by the renderer's own rules, with its background; a delegate need not do so
  state->vtkglViewport(0, 0, this->Size[0], this->Size[1]);
  state->vtkglEnable(GL_SCISSOR_TEST);
  state->vtkglScissor(0, 0, this->Size[0], this->Size[1]);
  this->Renderer->Clear();
}

void SmallFrame::End()
{
  vtkOpenGLState* const state = this->Window->GetState();
  state->PopFramebufferBindings();
  this->Renderer->SetViewport(this->Viewport);
  if (auto* const camera = vtkOpenGLCamera::SafeDownCast(this->Renderer->GetActiveCamera()))
  {
    camera->UpdateViewport(this->Renderer);
  }
  this->Enlarge();
}

void SmallFrame::ReadyProgram()
{
  if (!this->Quad)
  {
    this->Quad =
      std::make_unique<vtkOpenGLQuadHelper>(this->Window, nullptr, enlarge_fragment_glsl, nullptr);
  }
  else
  {
    this->Window->GetShaderCache()->ReadyShaderProgram(this->Quad->Program);
  }
}

void SmallFrame::Enlarge()
{
  vtkOpenGLState* const state = this->Window->GetState();
  vtkOpenGLState::ScopedglEnableDisable blend(state, GL_BLEND);
  vtkOpenGLState::ScopedglEnableDisable test(state, GL_DEPTH_TEST);
  vtkOpenGLState::ScopedglDepthFunc order(state);
  vtkOpenGLState::ScopedglDepthMask mask(state);
  vtkOpenGLState::ScopedglColorMask colors(state);
  state->vtkglDisable(GL_BLEND);
  state->vtkglEnable(GL_DEPTH_TEST); // or no depth is written
  state->vtkglDepthFunc(GL_ALWAYS);
  state->vtkglDepthMask(GL_TRUE);
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  this->ReadyProgram();
  vtkTextureObject* const color = this->Framebuffer->GetColorAttachmentAsTextureObject(0);
  vtkTextureObject* const depth = this->Framebuffer->GetDepthAttachmentAsTextureObject();
  if (!this->Quad->Program || !color || !depth)
  {
    this->Fails = true;
    vtkGenericWarningMacro(
      << "A smaller picture could not be enlarged: frames stay as large as the "
         "window, also while the view moves");
    return;
  }
  Filter(color, vtkTextureObject::Linear);
  Filter(depth, vtkTextureObject::Nearest);
  color->Activate();
  depth->Activate();
  this->Quad->Program->SetUniformi("wfvColors", color->GetTextureUnit());
  this->Quad->Program->SetUniformi("wfvDepths", depth->GetTextureUnit());
  this->Quad->Render();
  color->Deactivate();
  depth->Deactivate();
}

void SmallFrame::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Quad.reset();
  if (window)
  {
    this->Framebuffer->ReleaseGraphicsResources(window);
  }
  std::fill_n(this->Allocated, 2, 0);
}
}
