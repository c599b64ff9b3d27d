// SPDX-License-Identifier: BSD-3-Clause
// A scene in a renderer.
#ifndef WideFoVShownScene_h
#define WideFoVShownScene_h

#include "vtkWideFoVAbi.h"

#include "Look.h"
#include "Scene.h"

#include <vtkActor.h>
#include <vtkSmartPointer.h>
#include <vtkVolume.h>

#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkRenderer;
VTK_ABI_NAMESPACE_END

namespace widefov
{
struct ShownScene
{
  std::vector<vtkSmartPointer<vtkActor>> Actors; // one a prop of the scene
  std::vector<vtkSmartPointer<vtkVolume>> Volumes;
};

// Adds all that is drawn of the scene, and a light for files that say how they reflect it.
ShownScene ShowScene(vtkRenderer* renderer, const Scene& scene, const Look& look);

// Takes it away again, but for the light.
void HideScene(vtkRenderer* renderer, ShownScene& shown);
}

#endif
