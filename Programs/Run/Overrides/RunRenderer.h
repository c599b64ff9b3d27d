// SPDX-License-Identifier: BSD-3-Clause
// The renderer and the camera that programs get which asked for a vtkRenderer and a vtkCamera. They
// have no class names of their own: who asks sees those of the module.
#ifndef WideFoVRunRenderer_h
#define WideFoVRunRenderer_h

#include "Run/Wishes/Wishes.h"

#include <vtkWideFoVCamera.h>
#include <vtkWideFoVRenderer.h>

namespace widefov
{
// Those of the environment; ends the program where they are wrong.
const Wishes& TheWishes();

class RunCamera : public vtkWideFoVCamera
{
public:
  static RunCamera* New();

protected:
  RunCamera();

  // Inside, the eye is at the focal point, whatever the program does with its camera.
  void ComputeViewTransform() override;
  void GetViewpoint(double world[3]) override;
  vtkObjectBase* NewInstanceInternal() const override { return RunCamera::New(); }
};

class RunRenderer : public vtkWideFoVRenderer
{
public:
  static RunRenderer* New();

  // One that the factory makes.
  vtkCamera* MakeCamera() override;

  // What nobody can touch, such as the axes in a corner of the window, is shown flat.
  void DeviceRender() override;

protected:
  RunRenderer();
  vtkObjectBase* NewInstanceInternal() const override { return RunRenderer::New(); }

private:
  void DrawFlat();
};
}

#endif
