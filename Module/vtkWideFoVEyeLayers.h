// SPDX-License-Identifier: BSD-3-Clause
// A framebuffer with a layer for each eye, made like the one that a renderer draws to.
#ifndef vtkWideFoVEyeLayers_h
#define vtkWideFoVEyeLayers_h

#include "vtkWideFoVAbi.h"

#include <memory>

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLRenderWindow;
class vtkWindow;
VTK_ABI_NAMESPACE_END

namespace wfv
{
class EyeLayers
{
public:
  EyeLayers();
  ~EyeLayers();

  // Makes the layers as large as this and like the framebuffer that is bound to be drawn to, if
  // they are not. False where that cannot be had.
  bool Prepare(vtkOpenGLRenderWindow* window, const int size[2]);

  // Whether they are still like that.
  bool Fit(vtkOpenGLRenderWindow* window, const int size[2]) const;

  // Copies a part (x, y, width, height in pixels) of the framebuffer into both layers; from then on
  // what is drawn goes to them.
  void Begin(const int part[4]);

  // The framebuffer is bound again.
  void End();

  // Copies a part of a layer into the framebuffer that is bound.
  void Show(int layer, const int part[4]);

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  struct Internals;
  std::unique_ptr<Internals> Internal;
};
}

#endif
