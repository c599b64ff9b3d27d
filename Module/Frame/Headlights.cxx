// SPDX-License-Identifier: BSD-3-Clause
#include "Frame/Headlights.h"

#include "Camera/Tile.h"
#include "Camera/vtkWideFoVCamera.h"
#include "Compat/StockText.h"
#include "Drawables/StockTraits.h"
#include "Drawables/Volumes.h"
#include "Shaders/ShaderBuilder.h"
#include "WideFoVGlsl.h"

#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkObjectFactory.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkVolume.h"

vtkStandardNewMacro(vtkWideFoVHeadlights);

namespace wfv
{
int FindHeadlights(vtkRenderer* renderer)
{
  int lights = 0;
  int bit = 0;
  vtkCollectionSimpleIterator it;
  renderer->GetLights()->InitTraversal(it);
  while (vtkLight* light = renderer->GetLights()->GetNextLight(it))
  {
    if (light->GetSwitch())
    {
      const bool ahead = light->LightTypeIsHeadlight() && !light->GetPositional();
      lights |= ahead && bit < 31 ? 1 << bit : 0;
      bit++;
    }
  }
  // the one that VTK makes for a renderer without light, once it draws
  return bit == 0 && renderer->GetAutomaticLightCreation() ? 1 : lights;
}
}

void vtkWideFoVHeadlights::Begin(const vtkRenderState* s)
{
  this->Renderer = s->GetRenderer();
  this->Lights = wfv::FindHeadlights(s->GetRenderer());
  this->PreRender(s);
}

void vtkWideFoVHeadlights::Rewrite(const wfv::stock::Traits& traits, std::string& fragment)
{
  namespace stock = wfv::stock;
  const bool lit = traits.Light != stock::Lit::No;
  const bool alone = traits.Light == stock::Lit::Headlight;
  // what is behind it knows the place; impostors work it out before the light
  const size_t inside = stock::Look(fragment, stock::Edit::LightPlace, traits.If(lit)).At;
  if (inside == std::string::npos)
  {
    return;
  }
  std::string head = fragment.substr(0, inside);
  std::string body = fragment.substr(inside);
  wfv::ShaderBuilder::Declare(head, headlight_fragment_glsl);
  stock::Replace(body, stock::Edit::HeadlightCosine,
    "max($1, dot(normalVCVSOutput, -normalize(vertexVC.xyz)))",
    traits.If(alone && !traits.Physical));
  stock::Replace(body, stock::Edit::LightDirection,
    "wfvLightDirection($1, lightDirectionVC$1, vertexVC.xyz)", traits.If(lit && !alone));
  fragment = head + body;
}

bool vtkWideFoVHeadlights::PostReplaceShaderValues(
  std::string&, std::string&, std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop)
{
  std::string fragment = fragmentShader;
  const char* instead = "headlights shine along the view axis";
  if (auto* const volume = vtkVolume::SafeDownCast(prop))
  {
    wfv::volume::FinishFlat(wfv::volume::Describe(this->Renderer, volume), fragment);
    instead = "rays of volumes begin at the camera's position";
  }
  else
  {
    Rewrite(wfv::stock::Describe(mapper, prop), fragment);
  }
  if (!wfv::stock::ReportMissing(this, mapper, fragment, instead))
  {
    fragmentShader = fragment;
  }
  return true;
}

bool vtkWideFoVHeadlights::SetShaderParameters(
  vtkShaderProgram* program, vtkAbstractMapper*, vtkProp*, vtkOpenGLVertexArrayObject*)
{
  if (program->IsUniformUsed("wfvHeadlights"))
  {
    program->SetUniformi("wfvHeadlights", this->Lights);
  }
  if (program->IsUniformUsed("wfvFlatEye"))
  {
    float eye[3] = { 0, 0, 0 }; // which one is drawn the camera knows by now
    if (auto* camera = vtkWideFoVCamera::SafeDownCast(this->Renderer->GetActiveCamera()))
    {
      camera->GetPerspectiveEye(wfv::PictureAspect(this->Renderer), eye);
    }
    program->SetUniform3f("wfvFlatEye", eye);
  }
  return true;
}
