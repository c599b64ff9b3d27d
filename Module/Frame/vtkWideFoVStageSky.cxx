// SPDX-License-Identifier: BSD-3-Clause
// vtkWideFoVStage: what it does for the sky: what has no primitives, but a ray for each pixel.
#include "Frame/vtkWideFoVStage.h"

#include "Compat/Gl.h"
#include "Compat/StockText.h"
#include "Drawables/Sky.h"
#include "Frame/DirectionTextures.h"
#include "Frame/Stages.h"

#include "vtkAbstractMapper.h"
#include "vtkOpenGLRenderer.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"

wfv::ShaderBuilder::Request vtkWideFoVStage::MakeRayRequest() const
{
  wfv::ShaderBuilder::Request request;
  request.View = this->Seen;
  request.Lights.Headlights = this->Headlights;
  return request;
}

void vtkWideFoVStage::SetRayParameters(vtkShaderProgram* program)
{
  int viewport[4] = { 0, 0, 1, 1 };
  if (auto* renderer = vtkOpenGLRenderer::SafeDownCast(this->Renderer))
  {
    renderer->GetState()->vtkglGetIntegerv(GL_VIEWPORT, viewport);
  }
  this->SetFrameParameters(program, viewport);
  if (this->View.map && this->Textures)
  {
    this->Textures->Bind(program);
  }
  SetSampleParameters(program);
  wfv::sky::SetWorld(program, this->Stages->GetWorldToView());
}

bool vtkWideFoVStage::FinishSky(vtkAbstractMapper* mapper, vtkProp* prop, std::string& vertex,
  std::string& geometry, std::string& fragment)
{
  if (this->Variant != wfv::ShaderBuilder::Variant::Sky)
  {
    return false;
  }
  wfv::sky::Finish(this->MakeRayRequest(), wfv::sky::KindOf(prop), fragment);
  wfv::stock::LeaveOutUnedited(this->Renderer, mapper, vertex, geometry, fragment);
  Texts texts{ vertex, geometry, fragment };
  if (this->LeaveOutRefused(mapper, prop, texts))
  {
    wfv::stock::LeaveOut(vertex, geometry, fragment);
  }
  return true;
}

void vtkWideFoVStage::SetSkyParameters(vtkShaderProgram* program, vtkProp* prop) const
{
  if (this->Variant == wfv::ShaderBuilder::Variant::Sky)
  {
    wfv::sky::SetWorld(program, this->Stages->GetWorldToView());
    wfv::sky::SetTexture(program, prop, this->Renderer->GetRenderWindow());
  }
}
