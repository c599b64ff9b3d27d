// SPDX-License-Identifier: BSD-3-Clause
// How large the picture shows what is at a place.
#ifndef WideFoVPictureScale_h
#define WideFoVPictureScale_h

#include "vtkWideFoVAbi.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkRenderer;
class vtkWideFoVCamera;
VTK_ABI_NAMESPACE_END

namespace wfv
{
// Finds the way in the picture (heights of the picture to the right and up) of a small step from a
// place (world) in a direction, per radian of the step as seen from the eye. At a discontinuity it
// is that of the side where the map goes on.
void FindStep(vtkWideFoVCamera* camera, double aspect, const double place[3],
  const double direction[3], double way[2]);

// Returns the side of a square that covers a pixel of the renderer's picture where the place is
// seen, scene units; the mean of all directions. 0 where the map shows nothing.
double FindPixelSize(vtkRenderer* renderer, vtkWideFoVCamera* camera, const double place[3]);
}

#endif
