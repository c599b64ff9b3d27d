// SPDX-License-Identifier: BSD-3-Clause
// The bar of the colours: in the plane of the picture, or in a direction.
#ifndef WideFoVScalarBar_h
#define WideFoVScalarBar_h

#include "vtkWideFoVAbi.h"

#include "Options/Options.h"
#include "Scenes/Scene.h"

#include <vtkProp.h>
#include <vtkScalarBarActor.h>
#include <vtkSmartPointer.h>

VTK_ABI_NAMESPACE_BEGIN
class vtkRenderer;
VTK_ABI_NAMESPACE_END

namespace widefov
{
// The bar of the scene's colour map, or nullptr where it has none.
vtkSmartPointer<vtkScalarBarActor> MakeScalarBar(const Scene& scene);

// Puts a bar to its place in the picture, whole or a part.
void PlaceBar(vtkScalarBarActor* bar, const Options& options);

// Adds that bar to the renderer, where the options want it: what was added, or nullptr.
vtkSmartPointer<vtkProp> AddScalarBar(
  vtkRenderer* renderer, const Scene& scene, const Options& options);
}

#endif
