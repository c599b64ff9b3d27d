// SPDX-License-Identifier: BSD-3-Clause
// Sets up a window and its renderer for two eyes.
#ifndef WideFoVStereoWindow_h
#define WideFoVStereoWindow_h

#include "vtkWideFoVAbi.h"

#include "Options/Options.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkRenderWindow;
class vtkRenderer;
VTK_ABI_NAMESPACE_END

namespace widefov
{
// Sets the colours with which the window shows the layout anaglyph.
void SetAnaglyph(vtkRenderWindow* window, const Options& options);

// Adds the floating window and the letterbox that the options ask for.
void AddStereoWindow(vtkRenderer* renderer, const Options& options);
}

#endif
