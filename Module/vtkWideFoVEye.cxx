// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWideFoVEye.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkOpenGLVertexBufferObject.h"
#include "vtkOpenGLVertexBufferObjectGroup.h"
#include "vtkShaderProgram.h"
#include "vtkWideFoVGl.h"

#include <cmath>

namespace
{
// What a pass may know of a mapper only from inside.
class MapperAccess : public vtkOpenGLPolyDataMapper
{
public:
  // From the vertex buffer to model coordinates, row-major.
  static void BufferToModel(vtkOpenGLPolyDataMapper* mapper, double m[16])
  {
    vtkMatrix4x4::Identity(m);
    vtkOpenGLVertexBufferObjectGroup* const group = mapper->*(&MapperAccess::VBOs);
    vtkOpenGLVertexBufferObject* const buffer = group ? group->GetVBO("vertexMC") : nullptr;
    if (buffer && buffer->GetCoordShiftAndScaleEnabled())
    {
      // VTK keeps it transposed, as its uniforms are
      vtkMatrix4x4::Transpose((mapper->*(&MapperAccess::VBOShiftScale))->GetData(), m);
    }
  }
};
}

namespace wfv
{
EyeUniforms FindEyeUniforms(vtkShaderProgram* program)
{
  const auto handle = static_cast<GLuint>(program->GetHandle());
  EyeUniforms uniforms;
  uniforms.Known = glGetUniformLocation(handle, "wfvEyeKnown");
  uniforms.High = glGetUniformLocation(handle, "wfvEyeHigh");
  uniforms.Low = glGetUniformLocation(handle, "wfvEyeLow");
  return uniforms;
}

void SetEye(
  const EyeUniforms& uniforms, vtkOpenGLPolyDataMapper* mapper, vtkActor* actor, vtkCamera* camera)
{
  double m[16];
  MapperAccess::BufferToModel(mapper, m);
  vtkMatrix4x4::Multiply4x4(actor->GetMatrix()->GetData(), m, m);
  vtkMatrix4x4::Multiply4x4(camera->GetModelViewTransformMatrix()->GetData(), m, m);
  const double determinant = vtkMatrix4x4::Determinant(m);
  const bool known = determinant != 0 && std::isfinite(determinant);
  double inverse[16];
  vtkMatrix4x4::Invert(m, inverse);
  float high[3] = { 0, 0, 0 };
  float low[3] = { 0, 0, 0 };
  for (int i = 0; i < 3 && known; i++)
  {
    const double eye = inverse[4 * i + 3];
    // volatile: GCC 12 vectorizes the three lines without it, and then low[0] and low[1]
    // are 0 at -O2
    const volatile float rounded = static_cast<float>(eye);
    high[i] = rounded;
    low[i] = static_cast<float>(eye - rounded);
  }
  glUniform1i(uniforms.Known, known);
  glUniform3fv(uniforms.High, 1, high);
  glUniform3fv(uniforms.Low, 1, low);
}
}
