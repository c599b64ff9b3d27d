// SPDX-License-Identifier: BSD-3-Clause
// What is behind a scene: a colour, a gradient by direction, or a picture of the sky.
#ifndef WideFoVSkyPicture_h
#define WideFoVSkyPicture_h

#include "vtkWideFoVAbi.h"

#include "Options/Options.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkRenderer;
VTK_ABI_NAMESPACE_END

namespace widefov
{
// Reads the picture that --sky names. Throws a Failure with ExitFailed where it is none.
void LoadSky(Options& options);

// Puts it behind the scene, upright as --up says, its middle where the view looks by default.
void SetBackground(vtkRenderer* renderer, const Options& options);
}

#endif
