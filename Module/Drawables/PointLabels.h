// SPDX-License-Identifier: BSD-3-Clause
// Labels of places that mappers of overlays put into the picture: vtkLabelPlacementMapper,
// vtkLabeledDataMapper.
#ifndef WideFoVPointLabels_h
#define WideFoVPointLabels_h

#include "Drawables/Facing.h"
#include "vtkWideFoVAbi.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkActor2D;
class vtkRenderer;
class vtkWideFoVCamera;
VTK_ABI_NAMESPACE_END

namespace wfv
{
// Draws an overlay in the order of VTK's renderers: what lies in the scene, what shines through,
// what lies upon it.
void DrawOverlay(vtkActor2D* overlay, vtkRenderer* renderer);

// The same with labels, each turned about its place.
void DrawPointLabels(
  vtkActor2D* labels, vtkRenderer* renderer, vtkWideFoVCamera* camera, LabelUp up);
}

#endif
