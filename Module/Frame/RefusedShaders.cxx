// SPDX-License-Identifier: BSD-3-Clause
#include "Frame/RefusedShaders.h"

#include "Compat/Gl.h"
#include "Compat/Reports.h"

#include "vtkInformation.h"
#include "vtkInformationObjectBaseVectorKey.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLShaderProperty.h"
#include "vtkShader.h"
#include "vtkShaderProgram.h"

#include <map>
#include <sstream>
#include <utility>
#include <vector>

namespace wfv
{
namespace
{
using Texts = ShaderMemory::Texts;
using Sources = std::map<vtkShader::Type, std::string>;

// Of a prop's passes, in their order, those behind this one.
std::vector<vtkOpenGLRenderPass*> PassesBehind(vtkOpenGLRenderPass* pass, vtkProp* prop)
{
  vtkInformationObjectBaseVectorKey* const list = vtkOpenGLRenderPass::RenderPasses();
  vtkInformation* const info = prop->GetPropertyKeys();
  const int count = info && info->Has(list) ? info->Length(list) : 0;
  std::vector<vtkOpenGLRenderPass*> behind;
  bool passed = false;
  for (int i = 0; i < count; i++)
  {
    auto* const other = vtkOpenGLRenderPass::SafeDownCast(info->Get(list, i));
    if (passed && other)
    {
      behind.push_back(other);
    }
    passed = passed || other == pass;
  }
  return behind;
}

vtkOpenGLShaderProperty::ReplacementMap ReplacementsOf(vtkProp* prop)
{
  auto* const user = vtkOpenGLShaderProperty::SafeDownCast(prop->GetShaderProperty());
  return user ? user->GetAllShaderReplacements() : vtkOpenGLShaderProperty::ReplacementMap();
}

// As the mapper goes on with them.
Sources Finish(
  vtkOpenGLRenderPass* pass, vtkAbstractMapper* mapper, vtkProp* prop, const Texts& texts)
{
  Sources sources{ { vtkShader::Vertex, texts.Vertex }, { vtkShader::Geometry, texts.Geometry },
    { vtkShader::Fragment, texts.Fragment } };
  for (vtkOpenGLRenderPass* const other : PassesBehind(pass, prop))
  {
    other->PostReplaceShaderValues(sources[vtkShader::Vertex], sources[vtkShader::Geometry],
      sources[vtkShader::Fragment], mapper, prop);
  }
  for (const auto& [spec, by] : ReplacementsOf(prop))
  {
    const auto source = sources.find(spec.ShaderType);
    if (!spec.ReplaceFirst && source != sources.end())
    {
      vtkShaderProgram::Substitute(
        source->second, spec.OriginalValue, by.Replacement, by.ReplaceAll);
    }
  }
  return sources;
}

// VTK would say the whole text of the shader.
class Silence
{
public:
  Silence() { vtkObject::GlobalWarningDisplayOff(); }
  ~Silence() { vtkObject::SetGlobalWarningDisplay(this->Before); }
  Silence(const Silence&) = delete;
  void operator=(const Silence&) = delete;

private:
  const vtkTypeBool Before = vtkObject::GetGlobalWarningDisplay();
};

std::string LogOf(GLuint program)
{
  char text[1024] = "";
  glGetProgramInfoLog(program, sizeof(text), nullptr, text);
  return text;
}

// What of a program is refused, and why.
struct Refusal
{
  std::string What;
  std::string Log;
};

struct Kind
{
  GLenum Type;
  const char* Name;
};

const std::map<vtkShader::Type, Kind> Kinds{
  { vtkShader::Vertex, { GL_VERTEX_SHADER, "vertex shader" } },
  { vtkShader::Geometry, { GL_GEOMETRY_SHADER, "geometry shader" } },
  { vtkShader::Fragment, { GL_FRAGMENT_SHADER, "fragment shader" } },
};

// Once more, for VTK keeps the reason to itself. The first shader that is refused, or the program.
Refusal FindRefusal(const std::map<vtkShader::Type, vtkShader*>& shaders)
{
  Refusal refusal;
  const GLuint program = glCreateProgram();
  for (const auto& [type, kind] : Kinds)
  {
    const std::string source = shaders.at(type)->GetSource();
    if (source.empty() || !refusal.What.empty())
    {
      continue;
    }
    const GLuint shader = CompileShader(kind.Type, source, refusal.Log);
    if (shader)
    {
      glAttachShader(program, shader);
      glDeleteShader(shader); // with the program
    }
    else
    {
      refusal.What = kind.Name;
    }
  }
  if (refusal.What.empty())
  {
    glLinkProgram(program);
    refusal = { "program", LogOf(program) };
  }
  glDeleteProgram(program);
  return refusal;
}

// The one that names an error, or the first.
std::string LineOf(const std::string& log)
{
  std::istringstream lines(log);
  std::string first;
  for (std::string line; std::getline(lines, line);)
  {
    if (line.find("error") != std::string::npos || line.find("ERROR") != std::string::npos)
    {
      return line;
    }
    first = first.empty() ? line : first;
  }
  return first.empty() ? "without a reason" : first;
}

}

unsigned int CompileShader(unsigned int type, const std::string& source, std::string& log)
{
  const GLuint shader = glCreateShader(type);
  const char* text = source.c_str();
  glShaderSource(shader, 1, &text, nullptr);
  glCompileShader(shader);
  GLint done = 0;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &done);
  if (done)
  {
    return shader;
  }
  char said[1024] = "";
  glGetShaderInfoLog(shader, sizeof(said), nullptr, said);
  log = said;
  glDeleteShader(shader);
  return 0;
}

bool IsEditedFurther(vtkOpenGLRenderPass* pass, vtkProp* prop)
{
  return !PassesBehind(pass, prop).empty() || !ReplacementsOf(prop).empty();
}

bool IsRefused(vtkObject* object, vtkRenderWindow* window, vtkOpenGLRenderPass* pass,
  vtkAbstractMapper* mapper, vtkProp* prop, const Texts& texts)
{
  std::map<vtkShader::Type, vtkShader*> shaders;
  vtkNew<vtkShader> made[3];
  int n = 0;
  for (const auto& [type, source] : Finish(pass, mapper, prop, texts))
  {
    made[n]->SetType(type);
    made[n]->SetSource(source);
    shaders[type] = made[n++];
  }
  Refusal refusal;
  {
    const Silence silence;
    auto* const ours = static_cast<vtkOpenGLRenderWindow*>(window);
    if (ours->GetShaderCache()->ReadyShaderProgram(shaders))
    {
      return false;
    }
    refusal = FindRefusal(shaders);
  }
  ReportRefused(object, refusal.What + " of a " + mapper->GetClassName(), refusal.Log,
    "props that need it are not drawn");
  return true;
}

void ReportRefused(
  vtkObject* object, const std::string& what, const std::string& log, const char* instead)
{
  const std::string line = LineOf(log);
  if (IsNews("shader " + WithoutNumbers(line)))
  {
    vtkErrorWithObjectMacro(
      object, << "the graphics driver refuses the " << what << ": " << line << ": " << instead);
  }
}
}
