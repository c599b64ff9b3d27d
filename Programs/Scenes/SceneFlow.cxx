// SPDX-License-Identifier: BSD-3-Clause
// Analytic vector fields round the eye.
#include "ColorMaps.h"
#include "MeshBuilder.h"
#include "Scenes.h"
#include "Text/Angles.h"
#include "VectorField.h"

#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>

#include <cmath>

namespace widefov
{
namespace
{
const char* const VelocityName = "velocity";

// The Arnold-Beltrami-Childress flow, a steady solution of Euler's equations whose
// stream lines are chaotic.
Vector3 AbcFlow(const Vector3& p)
{
  const double a = std::sqrt(3.);
  const double b = std::sqrt(2.);
  const double c = 1;
  return { { a * std::sin(p[2]) + c * std::cos(p[1]), b * std::sin(p[0]) + a * std::cos(p[2]),
    c * std::sin(p[1]) + b * std::cos(p[0]) } };
}

// A vortex round the vertical axis that also rises.
Vector3 Vortex(const Vector3& p)
{
  const double r2 = p[0] * p[0] + p[2] * p[2];
  const double turn = 1 / (0.5 + 0.1 * r2);
  return { { -p[2] * turn, 0.4 * std::cos(0.5 * std::sqrt(r2)), p[0] * turn } };
}

// The field on a grid of n^3 points over [-half, half]^3.
vtkSmartPointer<vtkImageData> Sample(int n, double half, Vector3 (*field)(const Vector3&))
{
  vtkNew<vtkImageData> grid;
  const double spacing = 2 * half / (n - 1);
  grid->SetDimensions(n, n, n);
  grid->SetOrigin(-half, -half, -half);
  grid->SetSpacing(spacing, spacing, spacing);
  vtkNew<vtkFloatArray> vectors;
  vectors->SetName(VelocityName);
  vectors->SetNumberOfComponents(3);
  vectors->SetNumberOfTuples(grid->GetNumberOfPoints());
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); i++)
  {
    Vector3 p;
    grid->GetPoint(i, p.data());
    vectors->SetTuple(i, field(p).data());
  }
  grid->GetPointData()->SetVectors(vectors);
  return grid;
}

// Points evenly over a ball: a Fibonacci spiral in direction, the cube root in radius.
vtkSmartPointer<vtkPolyData> BallSeeds(int count, double inner, double outer)
{
  const double golden = Pi * (3 - std::sqrt(5.));
  vtkNew<vtkPoints> points;
  for (int i = 0; i < count; i++)
  {
    const double y = 1 - 2 * (i + 0.5) / count;
    const double share = std::fmod(0.5 + i * 0.7548776662466927, 1.);
    const double r =
      std::cbrt(inner * inner * inner + share * (outer * outer * outer - inner * inner * inner));
    const double s = r * std::sqrt(1 - y * y);
    points->InsertNextPoint(s * std::cos(golden * i), r * y, s * std::sin(golden * i));
  }
  vtkNew<vtkPolyData> seeds;
  seeds->SetPoints(points);
  return seeds;
}

Scene VelocityScene(
  const std::string& label, vtkPolyData* surface, vtkDataObject* source, const char* map)
{
  double range[2];
  surface->GetPointData()->GetArray(VelocityName)->GetRange(range, -1);
  SceneProp prop;
  prop.Surface = surface;
  prop.Source = source;
  prop.Label = label;
  prop.Array = VelocityName;
  prop.ColorMap = MakeColorMap(map, range[0], range[1], -1);
  Scene scene;
  scene.Props.push_back(prop);
  scene.Eye = Vector3{ { 0, 0, 0 } };
  return scene;
}

Scene MakeTubes(const std::string& label, int seeds, int sides, double radius, double step)
{
  const vtkSmartPointer<vtkImageData> grid = Sample(40, Pi, AbcFlow);
  TubeSettings settings;
  settings.Seeds = BallSeeds(seeds, 1, 3);
  settings.Radius = radius;
  settings.Sides = sides;
  settings.Length = 6;
  settings.Step = step;
  settings.AvoidRadius = 0.4; // a tube through the eye would hide the rest
  return VelocityScene(label, MakeStreamTubes(grid, VelocityName, settings), grid, "viridis");
}
}

Scene MakeFlow()
{
  return MakeTubes("flow", 240, 8, 0.02, 0.5);
}

Scene MakeFlowLarge()
{
  return MakeTubes("flow-large", 700, 12, 0.012, 0.3);
}

Scene MakeVectorCloud()
{
  // an even number a side, so that no arrow stands in the eye
  const vtkSmartPointer<vtkImageData> grid = Sample(12, 5.5, Vortex);
  ArrowSettings settings;
  settings.Length = 0.9; // of a spacing
  settings.Resolution = 12;
  return VelocityScene("vector-cloud", MakeArrows(grid, VelocityName, settings), grid, "viridis");
}
}
