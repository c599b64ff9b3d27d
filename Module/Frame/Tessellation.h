// SPDX-License-Identifier: BSD-3-Clause
// Tessellation stages for a VTK that has none: vtkShaderProgram takes them from 9.4 on,
// and no mapper asks for them before a program is linked. Both stages are therefore
// written from the finished geometry stage, attached to the linked program, and the
// program is linked again. This works in every VTK; one for 9.4 and later alone could
// hand vtkShader::TessControl and vtkShader::TessEvaluation to the shader cache instead.
#ifndef WideFoVTessellation_h
#define WideFoVTessellation_h

#include "Shaders/ShaderBuilder.h"
#include "vtkWideFoVAbi.h"

#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkShaderProgram;
VTK_ABI_NAMESPACE_END

namespace wfv
{
class WFV_EXPORT Tessellation
{
public:
  // Empty, or why the current OpenGL context cannot: one sentence.
  static std::string FindObstacle();

  // The two stages between the vertex stage and this finished geometry stage, whose inputs
  // they take over, name by name.
  static std::string ControlSource(
    const wfv::ShaderBuilder::Request& request, const std::string& geometry);
  static std::string EvaluationSource(
    const wfv::ShaderBuilder::Request& request, const std::string& geometry);

  // Whether the program has the stages: it draws patches then, and nothing else.
  static bool IsIn(vtkShaderProgram* program);

  // Adds them to a linked program of a Tessellate variant, which is bound. Its attributes
  // have new places then. Empty, or what OpenGL said; the program is as before then.
  static std::string AddTo(vtkShaderProgram* program, const wfv::ShaderBuilder::Request& request);

  // Draws triangles as patches from the bound index buffer. vertices: how many there are;
  // offset: what VTK adds to the number of a primitive.
  static void Draw(vtkShaderProgram* program, unsigned int vertices, int indices, int offset);
};
}

#endif
