// SPDX-License-Identifier: BSD-3-Clause
// The actor that draws a part of a scene.
#ifndef WideFoVSceneActor_h
#define WideFoVSceneActor_h

#include "Scene.h"

namespace widefov
{
// Makes an actor with a vtkWideFoVPolyDataMapper: only such can be tessellated.
vtkSmartPointer<vtkActor> MakeActor(const SceneProp& prop, const Look& look);
}

#endif
