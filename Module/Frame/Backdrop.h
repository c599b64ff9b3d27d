// SPDX-License-Identifier: BSD-3-Clause
// A renderer's background by the ray of each pixel.
#ifndef WideFoVBackdrop_h
#define WideFoVBackdrop_h

#include "vtkWideFoVAbi.h"

#include <memory>
#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLQuadHelper;
class vtkRenderer;
class vtkWideFoVStage;
VTK_ABI_NAMESPACE_END

namespace wfv
{
// The renderer's two colours: Background at its horizon and below, Background2 where
// vtkRenderer::EnvironmentUp points.
class Backdrop
{
public:
  Backdrop();
  ~Backdrop();

  // Over what is there, where the map has a direction. stage: knows the view.
  void Draw(vtkRenderer* renderer, vtkWideFoVStage* stage);

  void ReleaseGraphicsResources();

private:
  bool Prepare(vtkRenderer* renderer, vtkWideFoVStage* stage); // false: no program

  std::string Text; // of the program
  std::unique_ptr<vtkOpenGLQuadHelper> Quad;
};
}

#endif
