// SPDX-License-Identifier: BSD-3-Clause
#include "Normals.h"

#include <vtkCellData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyDataNormals.h>

namespace widefov
{
namespace
{
// Between faces that meet in an edge, not in a bent surface; degrees. VTK's own.
constexpr double FeatureAngle = 30;
}

void SmoothNormals(Scene& scene)
{
  for (SceneProp& prop : scene.Props)
  {
    vtkPolyData* const data = prop.Surface;
    if (prop.Kind == SceneProp::Shape::Mesh && !prop.InSpace && data->GetNumberOfPolys() > 0 &&
      data->GetNumberOfStrips() == 0 && data->GetPointData()->GetNormals() == nullptr &&
      data->GetCellData()->GetNormals() == nullptr)
    {
      vtkNew<vtkPolyDataNormals> normals;
      normals->SetInputData(data);
      normals->ConsistencyOff(); // cells keep their order
      normals->SetFeatureAngle(FeatureAngle);
      normals->Update();
      prop.Surface = normals->GetOutput();
    }
  }
}
}
