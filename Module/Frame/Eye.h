// SPDX-License-Identifier: BSD-3-Clause
// The eye in the coordinates of a mapper's vertex buffer, so that the vertex stage takes
// differences from the eye before it rotates: view coordinates are then accurate relative
// to the distance from the eye, not to the size of the scene's coordinates.
#ifndef WideFoVEye_h
#define WideFoVEye_h

#include "vtkWideFoVAbi.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkActor;
class vtkOpenGLPolyDataMapper;
class vtkShaderProgram;
VTK_ABI_NAMESPACE_END

namespace wfv
{
// wfvEyeHigh and wfvEyeLow (their sum is the eye, in double) and wfvEyeKnown, which is 0 where the
// way from model to view coordinates cannot be turned round: where a program has them, below 0
// where it has not. wfvToView turns along that way, where the driver has doubles. Every prop sets
// them, and to look their names up takes longer than that.
struct EyeUniforms
{
  int Known = -1;
  int High = -1;
  int Low = -1;
  int ToView = -1;
};
EyeUniforms FindEyeUniforms(vtkShaderProgram* program);

// The eye in world coordinates: the same for all props of a frame.
struct WorldEye
{
  double ToView[16]; // row-major
  double Place[4] = { 0, 0, 0, 1 };
  bool Known = false; // the way to view coordinates can be turned round
};
WorldEye FindWorldEye(const double worldToView[16]);

// Sets them in the program that is bound.
void SetEye(const EyeUniforms& uniforms, vtkOpenGLPolyDataMapper* mapper, vtkActor* actor,
  const WorldEye& eye);
}

#endif
