// SPDX-License-Identifier: BSD-3-Clause
// The eye in the coordinates of a mapper's vertex buffer, so that the vertex stage takes
// differences from the eye before it rotates: view coordinates are then accurate relative
// to the distance from the eye, not to the size of the scene's coordinates.
#ifndef vtkWideFoVEye_h
#define vtkWideFoVEye_h

class vtkActor;
class vtkCamera;
class vtkOpenGLPolyDataMapper;
class vtkShaderProgram;

namespace wfv
{
// Sets wfvEyeHigh and wfvEyeLow (their sum is the eye, in double) and wfvEyeKnown, which
// is 0 where the way from model to view coordinates cannot be turned round.
void SetEye(
  vtkShaderProgram* program, vtkOpenGLPolyDataMapper* mapper, vtkActor* actor, vtkCamera* camera);
}

#endif
