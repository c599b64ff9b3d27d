// SPDX-License-Identifier: BSD-3-Clause
// Data that fill space, drawn as such.
#ifndef WideFoVVolume_h
#define WideFoVVolume_h

#include "Look.h"
#include "Scene.h"

#include <vtkSmartPointer.h>
#include <vtkVolume.h>

#include <vector>

namespace widefov
{
// Makes props of the kind Volume, which ApplyLook colours by an array of theirs: with look.Volume
// those that fill space, and of files images, unless the look says what else to draw of them.
// Throws a Failure with ExitFailed where look.Volume finds none.
void ChooseVolumes(Scene& scene, const Look& look);

// Puts an outline in the place of each such prop, and its data among the scene's volumes: of
// images as they are, of other data sampled on a grid. Without an array it is a mesh again.
void TakeVolumes(Scene& scene);

// One a volume of the scene.
std::vector<vtkSmartPointer<vtkVolume>> MakeVolumes(const Scene& scene, const Look& look);

// Another opacity of what MakeVolumes made: the look's VolumeOpacity.
void SetOpacity(vtkVolume* volume, double factor);
}

#endif
