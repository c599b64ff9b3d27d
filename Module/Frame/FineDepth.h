// SPDX-License-Identifier: BSD-3-Clause
// How near is what has been drawn in a frame, in finer steps than a depth buffer's.
#ifndef WideFoVFineDepth_h
#define WideFoVFineDepth_h

#include "vtkWideFoVAbi.h"

#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkTextureObject.h"
#include "vtkWeakPointer.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkProp;
class vtkRenderer;
class vtkShaderProgram;
class vtkWindow;
VTK_ABI_NAMESPACE_END

namespace wfv
{
// 32 bits a pixel of the viewport, for programs that decide in double (fine_depth.glsl). Nothing is
// allocated or cleared in frames that draw with none.
class FineDepth
{
public:
  // Before the props of a frame: forgets what was drawn. It goes with the framebuffer that is bound
  // then; what is drawn to another one meanwhile is ordered by that one's depth alone.
  void Begin(vtkRenderer* renderer);

  // For a program that asks for it. What is translucent hides nothing; and where the depth buffer
  // does not let the nearest through alone, that is not asked for.
  void SetParameters(vtkShaderProgram* program, vtkProp* prop, const int viewport[4]);

  // After them.
  void End() { this->Window = nullptr; }

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  bool IsFor(const int viewport[4]) const;
  bool Prepare(const int viewport[4]);

  vtkWeakPointer<vtkOpenGLRenderWindow> Window; // of this frame; none: outside of one
  int Framebuffer = 0;
  int Viewport[4] = { 0, 0, 0, 0 };
  bool Cleared = false;
  vtkNew<vtkTextureObject> Nearest;
};
}

#endif
