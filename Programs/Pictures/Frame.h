// SPDX-License-Identifier: BSD-3-Clause
// What every program does with a frame: its parts in the plane of the picture, what VTK
// said about it, its pixels.
#ifndef WideFoVFrame_h
#define WideFoVFrame_h

#include "vtkWideFoVAbi.h"

#include "ImageOutput.h"
#include "Options/Options.h"
#include "System/Display.h"

#include <vtkProp.h>
#include <vtkSmartPointer.h>

VTK_ABI_NAMESPACE_BEGIN
class vtkRenderWindow;
class vtkRenderer;
class vtkWideFoVPass;
VTK_ABI_NAMESPACE_END

namespace widefov
{
// Puts what the pass counts onto the picture, where the options ask for it, with a warning where
// the picture is drawn in tiles; the prop, or nullptr.
vtkSmartPointer<vtkProp> AddOverlay(
  vtkRenderer* renderer, vtkWideFoVPass* pass, const Options& options, bool tiles);

// Throws a Failure with ExitFailed where this OpenGL cannot draw pictures of that size.
void CheckSize(const Options& options, const GlLimits& limits);

// What to ask of vtkRenderWindow::SetMultiSamples: 0 for none, and no more than there are,
// with a warning.
int UsableSamples(int samples, const GlLimits& limits);

// After drawing: an error of VTK ends the job by a Failure with ExitFailed; a warning is
// passed on.
void CheckMessages();

// The pixels of the last frame.
Picture ReadPicture(vtkRenderWindow* window);
}

#endif
