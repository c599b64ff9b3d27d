// SPDX-License-Identifier: BSD-3-Clause
// The render passes that the options ask for.
#ifndef WideFoVPasses_h
#define WideFoVPasses_h

#include "vtkWideFoVAbi.h"

#include "Options/Options.h"

#include <vtkSmartPointer.h>

VTK_ABI_NAMESPACE_BEGIN
class vtkPanoramicProjectionPass;
class vtkRenderer;
class vtkWideFoVPass;
VTK_ABI_NAMESPACE_END

namespace widefov
{
// VTK's own pass over six cube faces: --technique cubemap.
vtkSmartPointer<vtkPanoramicProjectionPass> MakeCubeMapPass(const Options& options);

// Draws by it. The renderer's cullers are taken off: stock VTK's leave out what its camera's
// frustum does not hold, and with it most props of the other five faces.
void SetCubeMapPass(vtkRenderer* renderer, vtkPanoramicProjectionPass* pass);

// Draws by the wide pass, with the culler that a renderer has of itself.
void SetWidePass(vtkRenderer* renderer, vtkWideFoVPass* pass);

// Whether the technique draws a perspective too: where that is asked for, or every triangle is to
// be drawn by the ray of each pixel.
bool DrawsPerspective(const Options& options);

// Technique and tolerance; the technique is not cubemap.
void SetUpWidePass(vtkWideFoVPass* pass, const Options& options);
}

#endif
