// SPDX-License-Identifier: BSD-3-Clause
#include "ShownScene.h"

#include "SceneActor.h"
#include "Text/Angles.h"
#include "Volume.h"

#include <vtkLight.h>
#include <vtkLightCollection.h>
#include <vtkNew.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <algorithm>

namespace widefov
{
namespace
{
bool IsPhysical(const SceneProp& prop)
{
  return prop.Material && prop.Material->GetProperty()->GetInterpolation() == VTK_PBR;
}

// VTK's physically based light divides what is reflected by pi, so that its own light leaves all
// dark: one as bright as those of files without materials.
void AddLight(vtkRenderer* renderer)
{
  vtkNew<vtkLight> light;
  light->SetLightTypeToHeadlight();
  light->SetIntensity(Pi);
  renderer->AddLight(light);
}
}

ShownScene ShowScene(vtkRenderer* renderer, const Scene& scene, const Look& look)
{
  ShownScene shown;
  for (const SceneProp& prop : scene.Props)
  {
    shown.Actors.push_back(MakeActor(prop, look));
    renderer->AddActor(shown.Actors.back());
  }
  shown.Volumes = MakeVolumes(scene, look);
  for (vtkVolume* const volume : shown.Volumes)
  {
    renderer->AddVolume(volume);
  }
  const bool lit = renderer->GetLights()->GetNumberOfItems() > 0; // by the scene before
  if (!lit && std::all_of(scene.Props.begin(), scene.Props.end(), IsPhysical))
  {
    AddLight(renderer);
  }
  return shown;
}

void HideScene(vtkRenderer* renderer, ShownScene& shown)
{
  for (vtkActor* const actor : shown.Actors)
  {
    renderer->RemoveActor(actor);
  }
  for (vtkVolume* const volume : shown.Volumes)
  {
    renderer->RemoveVolume(volume);
  }
  shown = ShownScene();
}
}
