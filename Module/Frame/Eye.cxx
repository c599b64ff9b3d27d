// SPDX-License-Identifier: BSD-3-Clause
#include "Frame/Eye.h"

#include "Camera/TwoFloats.h"
#include "Compat/Gl.h"

#include "vtkActor.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkOpenGLVertexBufferObject.h"
#include "vtkOpenGLVertexBufferObjectGroup.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <cmath>

namespace
{
// What a pass may know of a mapper only from inside.
class BufferAccess : public vtkOpenGLPolyDataMapper
{
public:
  // From the vertex buffer to model coordinates, row-major; false where they are the same.
  static bool BufferToModel(vtkOpenGLPolyDataMapper* mapper, double m[16])
  {
    vtkOpenGLVertexBufferObjectGroup* const group = mapper->*(&BufferAccess::VBOs);
    vtkOpenGLVertexBufferObject* const buffer = group ? group->GetVBO("vertexMC") : nullptr;
    const bool shifted = buffer && buffer->GetCoordShiftAndScaleEnabled();
    if (shifted)
    {
      // VTK keeps it transposed, as its uniforms are
      vtkMatrix4x4::Transpose((mapper->*(&BufferAccess::VBOShiftScale))->GetData(), m);
    }
    return shifted;
  }
};

// The uniform dmat3, of a row-major matrix.
void SetTurn(GLint location, const double m[16])
{
  if (location < 0)
  {
    return;
  }
  const double turn[9] = { m[0], m[1], m[2], m[4], m[5], m[6], m[8], m[9], m[10] };
  glUniformMatrix3dv(location, 1, GL_TRUE, turn);
}

// What a matrix takes to the origin; false where it cannot be turned round.
bool FindOrigin(const double m[16], double place[4])
{
  const double determinant = vtkMatrix4x4::Determinant(m);
  if (determinant == 0 || !std::isfinite(determinant))
  {
    return false;
  }
  double inverse[16];
  vtkMatrix4x4::Invert(m, inverse);
  for (int i = 0; i < 3; i++)
  {
    place[i] = inverse[4 * i + 3];
  }
  return true;
}
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
  uniforms.ToView = glGetUniformLocation(handle, "wfvToView");
  return uniforms;
}

WorldEye FindWorldEye(const double worldToView[16])
{
  WorldEye eye;
  std::copy_n(worldToView, 16, eye.ToView);
  eye.Known = FindOrigin(worldToView, eye.Place);
  return eye;
}

void SetEye(const EyeUniforms& uniforms, vtkOpenGLPolyDataMapper* mapper, vtkActor* actor,
  const WorldEye& eye)
{
  double buffer[16];
  const bool shifted = BufferAccess::BufferToModel(mapper, buffer);
  double place[4];
  std::copy_n(eye.Place, 4, place);
  bool known = eye.Known;
  double m[16];
  std::copy_n(eye.ToView, 16, m);
  if (shifted || !actor->GetIsIdentity())
  {
    // all of the way at once: what is far from the world's origin and near the eye keeps its digits
    vtkMatrix4x4::Multiply4x4(eye.ToView, actor->GetMatrix()->GetData(), m);
    if (shifted)
    {
      vtkMatrix4x4::Multiply4x4(m, buffer, m);
    }
    known = FindOrigin(m, place);
  }
  float high[3] = { 0, 0, 0 };
  float low[3] = { 0, 0, 0 };
  for (int i = 0; i < 3 && known; i++)
  {
    high[i] = static_cast<float>(place[i]);
    low[i] = LowPart(place[i]);
  }
  SetTurn(uniforms.ToView, m);
  glUniform1i(uniforms.Known, known);
  glUniform3fv(uniforms.High, 1, high);
  glUniform3fv(uniforms.Low, 1, low);
}
}
