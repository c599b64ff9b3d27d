// SPDX-License-Identifier: BSD-3-Clause
#include "Frame/Tessellation.h"

#include "Compat/Driver.h"
#include "Compat/Gl.h"
#include "Frame/RefusedShaders.h"
#include "Shaders/Limits.h"
#include "Shaders/ShaderText.h"
#include "WideFoVGlsl.h"

#include "vtkShader.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <regex>
#include <vector>

namespace
{
using wfv::shader::Request;
using wfv::shader::Varying;

// Small draws, where a driver needs them: few patches, or for meshes of many triangles, which are
// small as a rule, more patches of fewer pieces (past that they go exact). n pieces an edge have
// 1 + 3 (n / 2) (n / 2 + 1) corners, n even.
constexpr int SmallMesh = 10000; // triangles
constexpr int FewPatches = 20;   // of 64 pieces an edge: 3,169 corners each
constexpr int ManyPatches = 340; // of 14 pieces an edge: 169 corners each
constexpr int LessLevel = 14;

// Attached to a program of VTK's with a geometry stage.
constexpr int StockStages = 3;

std::string InControl(const Varying& v)
{
  return "wfvControl_" + v.Name;
}

std::vector<Varying> FindInputs(const std::string& geometry)
{
  static const std::regex input(R"((flat\s+)?\bin\s+(\w+)\s+(\w+)\s*\[\s*\]\s*;)");
  std::vector<Varying> result;
  for (std::sregex_iterator i(geometry.begin(), geometry.end(), input), end; i != end; ++i)
  {
    result.push_back({ (*i)[1].matched, (*i)[2], (*i)[3] });
  }
  return result;
}

std::string Head(const Request& request)
{
  return tess_head_glsl + wfv::shader::ViewSource(request) + wfv::shader::EdgeSource();
}

// The map's own functions are protected in vtkShaderProgram.
class ProgramAccess : public vtkShaderProgram
{
public:
  static void ForgetLocations(vtkShaderProgram* program)
  {
    (program->*(&ProgramAccess::ClearMaps))();
  }
};

// True where it links; its uniforms and attributes have new places then.
bool Link(vtkShaderProgram* program)
{
  const auto handle = static_cast<GLuint>(program->GetHandle());
  glLinkProgram(handle);
  GLint linked = 0;
  glGetProgramiv(handle, GL_LINK_STATUS, &linked);
  ProgramAccess::ForgetLocations(program);
  // linked again, a bound program gets its old stages anew, but no further ones (Mesa)
  glUseProgram(handle);
  return linked != 0;
}
}

std::string wfv::Tessellation::FindObstacle()
{
  if (!wfv::HasExtension("GL_ARB_tessellation_shader"))
  {
    return "this OpenGL has no tessellation shaders (OpenGL 4.0)";
  }
  GLint level = 0;
  glGetIntegerv(GL_MAX_TESS_GEN_LEVEL, &level);
  return level >= wfv::WFV_MOST_PIECES
    ? ""
    : "this OpenGL cuts an edge in " + std::to_string(level) + " at most, not in 64";
}

std::string wfv::Tessellation::ControlSource(const Request& request, const std::string& geometry)
{
  // first: strict compilers size the outputs by it
  std::string declarations = "layout(vertices = 3) out;\n";
  std::string body;
  for (const Varying& v : FindInputs(geometry))
  {
    declarations += v.Input();
    declarations += "out " + v.Type + " " + InControl(v) + "[];\n";
    body += "  " + InControl(v) + "[gl_InvocationID] = " + v.Name + "[gl_InvocationID];\n";
  }
  return Head(request) + "// WideFoV: from vertices to patches\n" + declarations +
    "void wfvPass()\n{\n" + body + "}\n" + tess_control_glsl;
}

std::string wfv::Tessellation::EvaluationSource(const Request& request, const std::string& geometry)
{
  std::string declarations = "vec3 wfvWeights = vec3(0.0); // of the three corners at this place\n";
  std::string body;
  for (const Varying& v : FindInputs(geometry))
  {
    const std::string in = InControl(v);
    declarations += "in " + v.Type + " " + in + "[];\n";
    declarations += (v.Flat ? "flat out " : "out ") + v.Type + " " + v.Name + ";\n";
    // flat: the corner that decides, the last; the primitive's number counts patches
    body += "  " + v.Name + " = ";
    body += v.Name == "wfvPrimitive" ? "gl_PrimitiveID;\n"
      : v.Flat                       ? in + "[2];\n"
               : "wfvWeights.x * " + in + "[0] + wfvWeights.y * " + in + "[1] + wfvWeights.z * " +
        in + "[2];\n";
  }
  return Head(request) + "// WideFoV: from patches to vertices\n" + declarations +
    "void wfvInterpolate()\n{\n" + body + "}\n" + tess_evaluation_glsl;
}

bool wfv::Tessellation::IsIn(vtkShaderProgram* program)
{
  GLint attached = 0;
  glGetProgramiv(static_cast<GLuint>(program->GetHandle()), GL_ATTACHED_SHADERS, &attached);
  return attached > StockStages;
}

std::string wfv::Tessellation::AddTo(vtkShaderProgram* program, const Request& request)
{
  const std::string geometry = program->GetGeometryShader()->GetSource();
  std::string log;
  const GLuint control =
    wfv::CompileShader(GL_TESS_CONTROL_SHADER, ControlSource(request, geometry), log);
  const GLuint evaluation = control
    ? wfv::CompileShader(GL_TESS_EVALUATION_SHADER, EvaluationSource(request, geometry), log)
    : 0;
  if (!evaluation)
  {
    glDeleteShader(control); // 0 is ignored
    return log;
  }
  const auto handle = static_cast<GLuint>(program->GetHandle());
  glAttachShader(handle, control);
  glAttachShader(handle, evaluation);
  if (!Link(program))
  {
    char text[1024] = "";
    glGetProgramInfoLog(handle, sizeof(text), nullptr, text);
    log = text;
    glDetachShader(handle, control);
    glDetachShader(handle, evaluation);
    Link(program);
  }
  // the program keeps what is attached to it
  glDeleteShader(control);
  glDeleteShader(evaluation);
  return log;
}

void wfv::Tessellation::Draw(
  vtkShaderProgram* program, unsigned int vertices, int indices, int offset)
{
  const bool small = wfv::NeedsSmallPatchDraws();
  const bool few = indices <= 3 * SmallMesh;
  const int most = !small ? indices : 3 * (few ? FewPatches : ManyPatches);
  program->SetUniformf(
    "wfvMaxLevel", static_cast<float>(small && !few ? LessLevel : wfv::WFV_MOST_PIECES));
  glPatchParameteri(GL_PATCH_VERTICES, 3);
  for (int first = 0; first < indices; first += most)
  {
    program->SetUniformi("PrimitiveIDOffset", offset + first / 3);
    const auto* from = reinterpret_cast<const void*>(first * sizeof(GLuint));
    glDrawRangeElements(
      GL_PATCHES, 0, vertices - 1, std::min(most, indices - first), GL_UNSIGNED_INT, from);
  }
}
