// SPDX-License-Identifier: BSD-3-Clause
// A frame that is drawn with fewer samples or pixels, and enlarged.
#ifndef WideFoVSmallFrame_h
#define WideFoVSmallFrame_h

#include "vtkWideFoVAbi.h"

#include "vtkNew.h"
#include "vtkOpenGLFramebufferObject.h"

#include <memory>

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLQuadHelper;
class vtkOpenGLRenderWindow;
class vtkRenderer;
class vtkRenderState;
class vtkWindow;
VTK_ABI_NAMESPACE_END

namespace wfv
{
// Whatever asks the renderer finds a smaller viewport meanwhile, at the corner of a framebuffer of
// one sample a pixel. It then fills the renderer's viewport: colours between its pixels are
// blended, depths are those of the nearest one.
class SmallFrame
{
public:
  SmallFrame();
  ~SmallFrame();

  // Not where pixels count (a selection, another pass's framebuffer), where the window shows a tile
  // of a picture, where the renderer draws over what is there already, and once it has failed.
  bool IsPossible(const vtkRenderState* s) const;

  // The viewport, so many times smaller on each side. After it everything is as in a window of that
  // size, but the framebuffer.
  void Shrink(vtkRenderer* renderer, int factor);

  // From here on everything is drawn there.
  void Begin();

  // Enlarged; the viewport and the framebuffer are those of before.
  void End();

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  void Allocate();
  void ReadyProgram();
  void Enlarge();

  vtkRenderer* Renderer = nullptr; // of this frame
  vtkOpenGLRenderWindow* Window = nullptr;
  double Viewport[4] = { 0, 0, 1, 1 }; // before
  int Size[2] = { 0, 0 };              // pixels of this frame
  vtkNew<vtkOpenGLFramebufferObject> Framebuffer;
  int Allocated[2] = { 0, 0 }; // of the framebuffer
  std::unique_ptr<vtkOpenGLQuadHelper> Quad;
  bool Fails = false;
};
}

#endif
