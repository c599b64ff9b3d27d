// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWideFoVReducedPass.h"

#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"
#include "vtkWideFoVCamera.h"

#include <algorithm>

vtkStandardNewMacro(vtkWideFoVReducedPass);

void vtkWideFoVReducedPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "DelegatePass: " << this->Delegate.Get() << "\n"
     << indent << "Factor: " << this->Factor << "\n";
}

void vtkWideFoVReducedPass::RenderDelegate(const vtkRenderState* s)
{
  if (this->Delegate)
  {
    // IceT's composite pass lends the camera the matrix of a flat picture, and takes it back; a
    // wide camera has no use for it, and would warn
    auto* const camera = vtkWideFoVCamera::SafeDownCast(s->GetRenderer()->GetActiveCamera());
    if (camera && camera->IsWide())
    {
      camera->UseExplicitProjectionTransformMatrixOff();
    }
    this->Delegate->Render(s);
    this->NumberOfRenderedProps = this->Delegate->GetNumberOfRenderedProps();
  }
}

void vtkWideFoVReducedPass::Render(const vtkRenderState* s)
{
  vtkRenderer* const renderer = s->GetRenderer();
  auto* const window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  if (this->Factor <= 1 || !window)
  {
    this->RenderDelegate(s);
    return;
  }
  // whole pixels, rounded as IceT's composite pass does
  const int* const size = window->GetActualSize();
  const int width = std::max(1, size[0] / this->Factor);
  const int height = std::max(1, size[1] / this->Factor);
  vtkOpenGLState* const state = window->GetState();
  vtkOpenGLState::ScopedglViewport viewport(state);
  vtkOpenGLState::ScopedglScissor scissor(state);
  state->vtkglViewport(0, 0, width, height);
  state->vtkglScissor(0, 0, width, height);
  double before[4];
  renderer->GetViewport(before);
  renderer->SetViewport(
    0, 0, width / static_cast<double>(size[0]), height / static_cast<double>(size[1]));
  this->RenderDelegate(s);
  renderer->SetViewport(before);
}

void vtkWideFoVReducedPass::ReleaseGraphicsResources(vtkWindow* window)
{
  if (this->Delegate)
  {
    this->Delegate->ReleaseGraphicsResources(window);
  }
  this->Superclass::ReleaseGraphicsResources(window);
}
