// SPDX-License-Identifier: BSD-3-Clause
#include "Surroundings.h"

#include "Angles.h"
#include "Datasets.h"
#include "MeshBuilder.h"

#include <vtkAppendPolyData.h>
#include <vtkDataSet.h>
#include <vtkGenericCell.h>
#include <vtkImageData.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPolygon.h>
#include <vtkRectilinearGrid.h>
#include <vtkStaticCellLocator.h>
#include <vtkStructuredGrid.h>
#include <vtkTriangleFilter.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace widefov
{
namespace
{
// Directions that are asked at a place: the share of what surrounds it is known to some percent.
constexpr int Directions = 256;

// Places that are asked beside the middle, shares of the bounds.
constexpr double Aside = 0.25;

// Evenly over the sphere: a spiral of the golden angle.
Vector3 DirectionNumber(int i)
{
  const double z = 1 - (2 * i + 1.) / Directions;
  const double angle = i * Pi * (3 - std::sqrt(5.));
  const double r = std::sqrt(1 - z * z);
  return { { r * std::cos(angle), r * std::sin(angle), z } };
}

// Every second triangle of a strip is wound the other way.
vtkSmartPointer<vtkPolyData> WithoutStrips(vtkPolyData* data)
{
  if (data->GetNumberOfStrips() == 0)
  {
    return data;
  }
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputData(data);
  triangles->Update();
  return triangles->GetOutput();
}

// All that has sides; nullptr where there is nothing.
vtkSmartPointer<vtkPolyData> Sides(const Scene& scene)
{
  vtkNew<vtkAppendPolyData> append;
  for (const SceneProp& prop : scene.Props)
  {
    if (prop.Kind == SceneProp::Shape::Mesh &&
      prop.Surface->GetNumberOfPolys() + prop.Surface->GetNumberOfStrips() > 0)
    {
      vtkNew<vtkPolyData> polygons;
      polygons->SetPoints(prop.Surface->GetPoints());
      polygons->SetPolys(prop.Surface->GetPolys());
      polygons->SetStrips(prop.Surface->GetStrips());
      append->AddInputData(WithoutStrips(polygons));
    }
  }
  if (append->GetNumberOfInputConnections(0) == 0)
  {
    return nullptr;
  }
  append->Update();
  return append->GetOutput();
}

// What is seen along rays from places of the scene.
class Looker
{
public:
  Looker(vtkPolyData* sides, double reach)
    : Reach(reach)
  {
    this->Locator->SetDataSet(sides);
    this->Locator->BuildLocator();
  }

  // Most directions end on a surface that faces the place.
  bool Surrounded(const Vector3& place)
  {
    int facing = 0;
    for (int i = 0; i < Directions; i++)
    {
      facing += this->Faces(place, DirectionNumber(i)) ? 1 : 0;
    }
    return 2 * facing > Directions;
  }

  double Distance(Vector3 place)
  {
    double closest[3];
    vtkIdType cell = -1;
    int part = 0;
    double squared = 0;
    this->Locator->FindClosestPoint(place.data(), closest, this->Cell, cell, part, squared);
    return squared;
  }

private:
  bool Faces(Vector3 from, const Vector3& direction)
  {
    Vector3 to = from + this->Reach * direction;
    double t = 0;
    double hit[3];
    double parameters[3];
    int part = 0;
    vtkIdType cell = -1;
    if (!this->Locator->IntersectWithLine(
          from.data(), to.data(), 0, t, hit, parameters, part, cell, this->Cell))
    {
      return false;
    }
    double normal[3];
    vtkPolygon::ComputeNormal(this->Cell->GetPoints(), normal);
    return vtkMath::Dot(normal, direction.data()) < 0;
  }

  vtkNew<vtkStaticCellLocator> Locator;
  vtkNew<vtkGenericCell> Cell;
  double Reach;
};

bool IsGrid(vtkDataSet* data)
{
  int dimensions[3] = { 1, 1, 1 };
  if (auto* const image = vtkImageData::SafeDownCast(data))
  {
    image->GetDimensions(dimensions);
  }
  else if (auto* const grid = vtkStructuredGrid::SafeDownCast(data))
  {
    grid->GetDimensions(dimensions);
  }
  else if (auto* const rectilinear = vtkRectilinearGrid::SafeDownCast(data))
  {
    rectilinear->GetDimensions(dimensions);
  }
  return dimensions[0] > 1 && dimensions[1] > 1 && dimensions[2] > 1;
}

bool FillsSpace(const SceneProp& prop)
{
  if (prop.InSpace || prop.Globe)
  {
    return true;
  }
  const std::vector<vtkSmartPointer<vtkDataSet>> leaves = Leaves(prop.Source);
  return std::any_of(leaves.begin(), leaves.end(), [](vtkDataSet* leaf) { return IsGrid(leaf); });
}

// Those that are surrounded; empty where most are not.
std::vector<Vector3> SurroundedPlaces(Looker& looker, const Vector3& middle, const Vector3& size)
{
  std::vector<Vector3> places{ middle };
  for (std::size_t axis = 0; axis < 3; axis++)
  {
    for (const double side : { -Aside, Aside })
    {
      places.push_back(middle);
      places.back()[axis] += side * size[axis];
    }
  }
  const std::size_t all = places.size();
  places.erase(std::remove_if(places.begin(), places.end(),
                 [&](const Vector3& place) { return !looker.Surrounded(place); }),
    places.end());
  return 2 * places.size() > all ? places : std::vector<Vector3>();
}
}

std::optional<Vector3> SurroundedPlace(const Scene& scene)
{
  double b[6];
  if (!SceneBounds(scene, b))
  {
    return std::nullopt;
  }
  const Vector3 middle{ { 0.5 * (b[0] + b[1]), 0.5 * (b[2] + b[3]), 0.5 * (b[4] + b[5]) } };
  const Vector3 size{ { b[1] - b[0], b[3] - b[2], b[5] - b[4] } };
  if (std::any_of(scene.Props.begin(), scene.Props.end(), FillsSpace))
  {
    return middle;
  }
  const vtkSmartPointer<vtkPolyData> sides = Sides(scene);
  if (!sides)
  {
    return std::nullopt;
  }
  Looker looker(sides, std::hypot(size[0], size[1], size[2]));
  const std::vector<Vector3> places = SurroundedPlaces(looker, middle, size);
  if (places.empty() || places.front() == middle)
  {
    return places.empty() ? std::nullopt : std::optional(middle);
  }
  return *std::max_element(places.begin(), places.end(),
    [&](const Vector3& a, const Vector3& b) { return looker.Distance(a) < looker.Distance(b); });
}
}
