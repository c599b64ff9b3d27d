// SPDX-License-Identifier: BSD-3-Clause
// What the renderer answers to VTK's own pickers.
#ifndef WideFoVPickerAnswer_h
#define WideFoVPickerAnswer_h

#include "Camera/FlatQuestions.h"
#include "vtkWideFoVAbi.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkRenderer;
class vtkWideFoVCamera;
VTK_ABI_NAMESPACE_END

namespace wfv
{
// The ray by which a picker that looks from the camera's position finds what is seen at a place of
// the picture (NDC). Where the view's own ray begins elsewhere, as an eye's does, it leads to what
// that ray hits, and begins just before it, for what stands between is not seen there.
PickRay FindPickRay(vtkRenderer* renderer, vtkWideFoVCamera* camera, const double ndc[2]);

// The diagonal of the window in scene units, at a place of the world: as many pixels long, of the
// size that a pixel has there. Corners themselves may be outside of the map, or anywhere.
double FindDiagonal(vtkRenderer* renderer, vtkWideFoVCamera* camera, const double place[3]);
}

#endif
