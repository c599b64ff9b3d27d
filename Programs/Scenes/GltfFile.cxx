// SPDX-License-Identifier: BSD-3-Clause
#include "GltfFile.h"

#include <vtkActorCollection.h>
#include <vtkDataArray.h>
#include <vtkGLTFImporter.h>
#include <vtkInformation.h>
#include <vtkInformationDoubleVectorKey.h>
#include <vtkMapper.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkProp.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkTransform.h>
#include <vtkTransformPolyDataFilter.h>

#include "Compat/Renamed.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

namespace widefov
{
namespace
{
// The colours of points, red, green, blue and perhaps alpha, in glTF's words.
const char* const PointColors = "COLOR_0";

// The importer's mapper turns texture coordinates over by a key of its actor.
void TurnTextures(vtkActor* actor, vtkPolyData* data)
{
  vtkInformation* const keys = actor->GetPropertyKeys();
  vtkDataArray* const from = data->GetPointData()->GetTCoords();
  if (keys == nullptr || from == nullptr || !keys->Has(wfv::TextureTransform()))
  {
    return;
  }
  const double* const m = keys->Get(wfv::TextureTransform());
  vtkSmartPointer<vtkDataArray> to;
  to.TakeReference(from->NewInstance());
  to->DeepCopy(from);
  for (vtkIdType i = 0; i < from->GetNumberOfTuples(); i++)
  {
    const double u = from->GetComponent(i, 0);
    const double v = from->GetComponent(i, 1);
    to->SetComponent(i, 0, m[0] * u + m[1] * v + m[3]);
    to->SetComponent(i, 1, m[4] * u + m[5] * v + m[7]);
  }
  data->GetPointData()->SetTCoords(to);
}

SceneProp PropOf(vtkActor* actor)
{
  actor->GetMapper()->Update();
  vtkNew<vtkTransform> place;
  place->SetMatrix(actor->GetMatrix());
  vtkNew<vtkTransformPolyDataFilter> placed;
  placed->SetInputDataObject(actor->GetMapper()->GetInputDataObject(0, 0));
  placed->SetTransform(place);
  placed->Update();
  SceneProp prop;
  prop.Surface = placed->GetOutput();
  TurnTextures(actor, prop.Surface);
  prop.Source = prop.Surface;
  prop.Material = actor;
  if (prop.Surface->GetPointData()->GetArray(PointColors) != nullptr)
  {
    prop.Array = PointColors;
    prop.Direct = true;
  }
  return prop;
}
}

bool IsGltf(const std::string& path)
{
  std::string ending = std::filesystem::path(path).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending == ".glb" || ending == ".gltf";
}

std::vector<SceneProp> ReadGltf(const std::string& path)
{
  vtkNew<vtkRenderWindow> nowhere; // never opened: the importer fills a renderer of its own
  vtkNew<vtkRenderer> renderer;
  nowhere->AddRenderer(renderer);
  vtkNew<vtkGLTFImporter> importer;
  importer->SetFileName(path.c_str());
  importer->SetRenderWindow(nowhere);
  importer->Update();
  std::vector<SceneProp> props;
  vtkActorCollection* const actors = renderer->GetActors();
  actors->InitTraversal();
  while (vtkActor* const actor = actors->GetNextActor())
  {
    const SceneProp prop = PropOf(actor);
    if (prop.Surface->GetNumberOfPoints() > 0)
    {
      props.push_back(prop);
    }
  }
  return props;
}
}
