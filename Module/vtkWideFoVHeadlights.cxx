// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWideFoVHeadlights.h"

#include "WideFoVGlsl.h"
#include "vtkWideFoVShaderBuilder.h"
#include "vtkWideFoVShaderText.h"

#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkObjectFactory.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"

#include <regex>

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
  this->Lights = wfv::FindHeadlights(s->GetRenderer());
  this->PreRender(s);
}

void vtkWideFoVHeadlights::Rewrite(std::string& fragment)
{
  // what is behind it knows the place; imposters work it out before the light
  const size_t inside = fragment.find("vec4 vertexVC = ");
  if (inside == std::string::npos)
  {
    return;
  }
  std::string head = fragment.substr(0, inside);
  std::string body = fragment.substr(inside);
  vtkWideFoVShaderBuilder::Declare(head, headlight_fragment_glsl);
  wfv::shader::ReplaceAll(body, "max(0.0,normalVCVSOutput.z)",
    "max(0.0, dot(normalVCVSOutput, -normalize(vertexVC.xyz)))");
  body = std::regex_replace(body, std::regex(R"(\blightDirectionVC(\d+))"),
    "wfvLightDirection($1, lightDirectionVC$1, vertexVC.xyz)");
  fragment = head + body;
}

bool vtkWideFoVHeadlights::PostReplaceShaderValues(
  std::string&, std::string&, std::string& fragmentShader, vtkAbstractMapper*, vtkProp*)
{
  Rewrite(fragmentShader);
  return true;
}

bool vtkWideFoVHeadlights::SetShaderParameters(
  vtkShaderProgram* program, vtkAbstractMapper*, vtkProp*, vtkOpenGLVertexArrayObject*)
{
  if (program->IsUniformUsed("wfvHeadlights"))
  {
    program->SetUniformi("wfvHeadlights", this->Lights);
  }
  return true;
}
