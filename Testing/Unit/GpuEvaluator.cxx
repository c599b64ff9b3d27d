// SPDX-License-Identifier: BSD-3-Clause
#include "GpuEvaluator.h"

#include <vtkNew.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLQuadHelper.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkPixelBufferObject.h>
#include <vtkRenderer.h>
#include <vtkShaderProgram.h>
#include <vtkTextureObject.h>
#include <Gl.h>

namespace wfv
{
namespace test
{
namespace
{
// As many Newton steps as the module's own shaders take.
const char* const Head = "//VTK::System::Dec\n//VTK::Output::Dec\n"
                         "#define WFV_FN\n#define WFV_TABLES int\n"
                         "#define WFV_DEPTH_MAPPING(v) v.depthMapping\n#define WFV_TILTED true\n"
                         "#define WFV_LENSED true\n"
                         "#define WFV_FADES true\n";

const char* const Tail = "uniform WfvView wfvView;\n"
                         "uniform sampler2D wfvDirections;\n"
                         "uniform sampler2D wfvPoints;\n"
                         "in vec2 texCoord;\n"
                         "void main()\n{\n"
                         "  ivec2 at = ivec2(texCoord * vec2(textureSize(wfvPoints, 0)));\n"
                         "  vec2 p = wfvProject(texelFetch(wfvDirections, at, 0).xyz, wfvView);\n"
                         "  WfvRay r = wfvUnproject(texelFetch(wfvPoints, at, 0).xy, wfvView);\n"
                         "  float rho = texelFetch(wfvDirections, at, 0).w;\n"
                         "  float depth = wfvDepthOf(rho, wfvView);\n"
                         "  gl_FragData[0] = vec4(p, depth, wfvDistanceAt(depth, wfvView));\n"
                         "  gl_FragData[1] = vec4(r.direction, r.inside ? 1.0 : 0.0);\n"
                         "}\n";

void SetView(vtkShaderProgram* program, const WfvView& v)
{
  const auto set2 = [program](const char* name, const vec2& value) {
    const float f[2] = { float(value.x), float(value.y) };
    if (program->IsUniformUsed(name))
    {
      program->SetUniform2f(name, f);
    }
  };
  set2("wfvView.halfFov", v.halfFov);
  set2("wfvView.scale", v.scale);
  set2("wfvView.radii", v.radii);
  program->SetUniformi("wfvView.depthMapping", v.depthMapping);
  const float lens[4] = { float(v.lens.x), float(v.lens.y), float(v.lens.z), float(v.lens.w) };
  const float high[4] = { float(v.lensHigh.x), float(v.lensHigh.y), float(v.lensHigh.z),
    float(v.lensHigh.w) };
  if (program->IsUniformUsed("wfvView.lens"))
  {
    program->SetUniform4f("wfvView.lens", lens);
    program->SetUniform4f("wfvView.lensHigh", high);
  }
  for (const auto& f :
    { std::make_pair("wfvView.lens5", v.lens5), std::make_pair("wfvView.maxAngle", v.maxAngle) })
  {
    if (program->IsUniformUsed(f.first))
    {
      program->SetUniformf(f.first, float(f.second));
    }
  }
}
}

struct GpuEvaluator::Internals
{
  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;

  vtkOpenGLRenderWindow* GetWindow() { return vtkOpenGLRenderWindow::SafeDownCast(this->Window); }

  vtkSmartPointer<vtkTextureObject> Upload(const std::vector<Texel>& data)
  {
    auto texture = this->Make();
    texture->Create2DFromRaw(Side, Side, 4, VTK_FLOAT, const_cast<float*>(data.front().data()));
    return texture;
  }

  vtkSmartPointer<vtkTextureObject> Make()
  {
    auto texture = vtkSmartPointer<vtkTextureObject>::New();
    texture->SetContext(this->GetWindow());
    texture->SetInternalFormat(GL_RGBA32F);
    texture->SetFormat(GL_RGBA);
    texture->SetDataType(GL_FLOAT);
    texture->SetMinificationFilter(vtkTextureObject::Nearest);
    texture->SetMagnificationFilter(vtkTextureObject::Nearest);
    return texture;
  }

  // Draws one quad from the two inputs into the two outputs.
  void Draw(vtkOpenGLQuadHelper& quad, const WfvView& view, vtkTextureObject* const inputs[2],
    vtkTextureObject* const outputs[2]);

  static void Download(vtkTextureObject* texture, std::vector<Texel>& data)
  {
    data.resize(std::size_t(Side) * Side);
    unsigned int size[2] = { Side, Side };
    vtkIdType increments[2] = { 0, 0 };
    vtkPixelBufferObject* buffer = texture->Download();
    buffer->Download2D(VTK_FLOAT, data.front().data(), size, 4, increments);
    buffer->Delete();
  }
};

GpuEvaluator::GpuEvaluator()
  : Internal(new Internals)
{
  this->Internal->Window->SetOffScreenRendering(1);
  this->Internal->Window->SetMultiSamples(0);
  this->Internal->Window->SetSize(64, 64);
  this->Internal->Window->AddRenderer(this->Internal->Renderer);
  this->Internal->Window->Render();
}

GpuEvaluator::~GpuEvaluator() = default;

std::string GpuEvaluator::GetRenderer() const
{
  return reinterpret_cast<const char*>(glGetString(GL_RENDERER));
}

void GpuEvaluator::Internals::Draw(vtkOpenGLQuadHelper& quad, const WfvView& view,
  vtkTextureObject* const inputs[2], vtkTextureObject* const outputs[2])
{
  vtkOpenGLRenderWindow* window = this->GetWindow();
  vtkOpenGLState* state = window->GetState();
  vtkNew<vtkOpenGLFramebufferObject> target;
  target->SetContext(window);
  state->PushFramebufferBindings();
  target->Bind();
  for (int i = 0; i < 2; ++i)
  {
    outputs[i]->Allocate2D(Side, Side, 4, VTK_FLOAT);
    target->AddColorAttachment(i, outputs[i]);
    inputs[i]->Activate();
  }
  target->ActivateDrawBuffers(2);
  vtkOpenGLState::ScopedglViewport viewport(state);
  state->vtkglViewport(0, 0, Side, Side);
  state->vtkglScissor(0, 0, Side, Side);
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglDisable(GL_BLEND);
  quad.Program->SetUniformi("wfvDirections", inputs[0]->GetTextureUnit());
  quad.Program->SetUniformi("wfvPoints", inputs[1]->GetTextureUnit());
  SetView(quad.Program, view);
  quad.Render();
  inputs[0]->Deactivate();
  inputs[1]->Deactivate();
  state->PopFramebufferBindings();
  target->ReleaseGraphicsResources(window);
}

bool GpuEvaluator::Evaluate(const View& view, const std::vector<Texel>& directions,
  const std::vector<Texel>& ndc, std::vector<Texel>& projected, std::vector<Texel>& unprojected)
{
  Internals& in = *this->Internal;
  vtkOpenGLRenderWindow* window = in.GetWindow();
  const std::string source = std::string(Head) + MathGlsl() + "\n" + CommonGlsl() + "\n" +
    DepthGlsl() + "\n" + view.GetProjection().Glsl + "\n" + Tail;
  vtkOpenGLQuadHelper quad(window, nullptr, source.c_str(), nullptr);
  if (!quad.Program || !quad.Program->GetCompiled())
  {
    return false;
  }
  const auto directionTexture = in.Upload(directions);
  const auto pointTexture = in.Upload(ndc);
  const auto first = in.Make();
  const auto second = in.Make();
  vtkTextureObject* const inputs[2] = { directionTexture, pointTexture };
  vtkTextureObject* const outputs[2] = { first, second };
  in.Draw(quad, view.GetParameters(), inputs, outputs);
  Internals::Download(first, projected);
  Internals::Download(second, unprojected);
  for (vtkTextureObject* t : { inputs[0], inputs[1], outputs[0], outputs[1] })
  {
    t->ReleaseGraphicsResources(window);
  }
  return true;
}
}
}
