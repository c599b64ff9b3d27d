// SPDX-License-Identifier: BSD-3-Clause
#include "Frame/Backdrop.h"

#include "Compat/Gl.h"
#include "Compat/Reports.h"
#include "Frame/vtkWideFoVStage.h"
#include "Shaders/sky/SkyShaders.h"

#include "vtkMath.h"
#include "vtkOpenGLQuadHelper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"

#include <algorithm>

namespace wfv
{
namespace
{
void SetColor(vtkShaderProgram* program, const char* name, const double* value)
{
  float f[3];
  std::copy_n(value, 3, f);
  program->SetUniform3f(name, f);
}
}

Backdrop::Backdrop() = default;
Backdrop::~Backdrop() = default;

bool Backdrop::Prepare(vtkRenderer* renderer, vtkWideFoVStage* stage)
{
  auto* const window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  const std::string text = sky::GradientSource(stage->MakeRayRequest());
  if (!this->Quad || text != this->Text)
  {
    this->Text = text;
    this->Quad = std::make_unique<vtkOpenGLQuadHelper>(window, nullptr, text.c_str(), nullptr);
  }
  else
  {
    window->GetShaderCache()->ReadyShaderProgram(this->Quad->Program);
  }
  return this->Quad->Program != nullptr;
}

void Backdrop::Draw(vtkRenderer* renderer, vtkWideFoVStage* stage)
{
  if (!this->Prepare(renderer, stage))
  {
    if (IsNews("gradient by direction"))
    {
      vtkGenericWarningMacro(<< "a gradient by direction could not be drawn: the graphics driver "
                                "refuses its shaders");
    }
    return;
  }
  auto* const window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  vtkOpenGLState* const state = window->GetState();
  const vtkOpenGLState::ScopedglEnableDisable blend(state, GL_BLEND);
  const vtkOpenGLState::ScopedglEnableDisable test(state, GL_DEPTH_TEST);
  const vtkOpenGLState::ScopedglDepthMask mask(state);
  state->vtkglDisable(GL_BLEND);
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglDepthMask(GL_FALSE);
  vtkShaderProgram* const program = this->Quad->Program;
  stage->SetRayParameters(program);
  double up[3];
  std::copy_n(renderer->GetEnvironmentUp(), 3, up);
  vtkMath::Normalize(up);
  SetColor(program, "wfvHorizon", renderer->GetBackground());
  SetColor(program, "wfvZenith", renderer->GetBackground2());
  SetColor(program, "wfvUp", up);
  this->Quad->Render();
}

void Backdrop::ReleaseGraphicsResources()
{
  this->Quad.reset();
}
}
