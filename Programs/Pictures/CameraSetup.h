// SPDX-License-Identifier: BSD-3-Clause
// The camera that the options describe.
#ifndef WideFoVCameraSetup_h
#define WideFoVCameraSetup_h

#include "vtkWideFoVAbi.h"

#include "Options/Options.h"
#include "Scenes/Scene.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkRenderer;
VTK_ABI_NAMESPACE_END

namespace widefov
{
struct Pose
{
  Vector3 Eye;
  Vector3 Direction; // unit length
  Vector3 Up;        // unit length, not parallel to Direction
};

// The direction of view where none is given: -z, or +y where that is not at an angle to up.
Vector3 UsualDirection(const Vector3& up);

// Throws a Failure with ExitUsage where the directions do not make a camera.
Pose MakePose(const Scene& scene, const Options& options);

// A vector in view coordinates (x right, y up, -z ahead) in those of the world.
Vector3 ToWorld(const Pose& pose, const wfv::vec3& v);

// Sets the renderer's camera: a vtkWideFoVCamera, or for the technique cubemap a new
// stock one.
void SetCamera(vtkRenderer* renderer, const Scene& scene, const Options& options);
}

#endif
