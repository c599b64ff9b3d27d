// SPDX-License-Identifier: BSD-3-Clause
#include "Scene.h"

#include <vtkBoundingBox.h>
#include <vtkCellArray.h>

namespace widefov
{
bool SceneBounds(const Scene& scene, double bounds[6])
{
  vtkBoundingBox box;
  for (const SceneProp& prop : scene.Props)
  {
    if (prop.Surface->GetNumberOfPoints() > 0)
    {
      vtkBoundingBox own(prop.Surface->GetBounds());
      if (prop.Margin > 0)
      {
        own.Inflate(prop.Margin);
      }
      box.AddBox(own);
    }
  }
  box.GetBounds(bounds);
  return box.IsValid() != 0;
}

Vector3 SceneEye(const Scene& scene)
{
  double b[6];
  if (scene.Eye || !SceneBounds(scene, b))
  {
    return scene.Eye.value_or(Vector3{ { 0, 0, 0 } });
  }
  return { { 0.5 * (b[0] + b[1]), 0.5 * (b[2] + b[3]), 0.5 * (b[4] + b[5]) } };
}

PrimitiveCount CountPrimitives(const Scene& scene)
{
  PrimitiveCount count;
  for (const SceneProp& prop : scene.Props)
  {
    vtkPolyData* const data = prop.Surface;
    const auto excess = [](vtkCellArray* cells, int ends) {
      return cells->GetNumberOfConnectivityIds() - ends * cells->GetNumberOfCells();
    };
    count.Triangles += excess(data->GetPolys(), 2) + excess(data->GetStrips(), 2);
    count.Lines += excess(data->GetLines(), 1);
    const vtkIdType points = data->GetVerts()->GetNumberOfConnectivityIds();
    // a stick is a line from end to end
    (prop.Kind == SceneProp::Shape::Sticks ? count.Lines : count.Points) += points;
  }
  return count;
}
}
