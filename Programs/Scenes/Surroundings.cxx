// SPDX-License-Identifier: BSD-3-Clause
#include "Surroundings.h"

#include "Datasets.h"
#include "MeshBuilder.h"
#include "SceneActor.h"
#include "Text/Angles.h"

#include <vtkAppendPolyData.h>
#include <vtkGenericCell.h>
#include <vtkCamera.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPolygon.h>
#include <vtkStaticCellLocator.h>
#include <vtkTriangleFilter.h>
#include <vtkWideFoVRenderer.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace widefov
{
namespace
{
// Directions that are asked at a place: the share of what surrounds it is known to some percent.
constexpr int Directions = 256;

// Of the bounds' volume, what is seen from a place that is in a room. The insides of models, whose
// faces are wound either way in files, are seen to fill less of their bounds: bunny and teapot 0.3.
constexpr double LeastVolume = 0.4;

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
  Looker(vtkPolyData* sides, const double bounds[6])
  {
    std::copy(bounds, bounds + 6, this->Bounds);
    this->Locator->SetDataSet(sides);
    this->Locator->BuildLocator();
  }

  // Most directions end on a surface that faces the place, and much of the bounds is seen.
  bool Surrounded(const Vector3& place)
  {
    int facing = 0;
    double cubes = 0; // of distances: as the volume that is seen
    for (int i = 0; i < Directions; i++)
    {
      const Vector3 direction = DirectionNumber(i);
      double distance = this->ToBounds(place, direction);
      facing += this->Faces(place, direction, distance) ? 1 : 0;
      cubes += std::pow(distance, 3);
    }
    const double* const b = this->Bounds;
    const double whole = (b[1] - b[0]) * (b[3] - b[2]) * (b[5] - b[4]);
    return 2 * facing > Directions && 4 * Pi / 3 * cubes / Directions > LeastVolume * whole;
  }

  double SquaredDistance(Vector3 place)
  {
    double closest[3];
    vtkIdType cell = -1;
    int part = 0;
    double squared = 0;
    this->Locator->FindClosestPoint(place.data(), closest, this->Cell, cell, part, squared);
    return squared;
  }

private:
  double ToBounds(const Vector3& from, const Vector3& direction) const
  {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < 3; i++)
    {
      const double end = this->Bounds[2 * i + (direction[i] > 0 ? 1 : 0)];
      least = direction[i] != 0 ? std::min(least, (end - from[i]) / direction[i]) : least;
    }
    return least;
  }

  // Of what is seen first; its distance, or as it was where nothing is.
  bool Faces(Vector3 from, const Vector3& direction, double& distance)
  {
    Vector3 to = from + 1.01 * distance * direction;
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
    distance = std::sqrt(vtkMath::Distance2BetweenPoints(from.data(), hit));
    double normal[3];
    vtkPolygon::ComputeNormal(this->Cell->GetPoints(), normal);
    return vtkMath::Dot(normal, direction.data()) < 0;
  }

  vtkNew<vtkStaticCellLocator> Locator;
  vtkNew<vtkGenericCell> Cell;
  double Bounds[6];
};

bool SurroundsAll(const SceneProp& prop)
{
  return prop.InSpace || prop.Globe || IsSpatialGrid(prop.Source);
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

Vector3 FreePlace(const Scene& scene)
{
  vtkNew<vtkWideFoVRenderer> renderer; // it draws nothing
  for (const SceneProp& prop : scene.Props)
  {
    renderer->AddActor(MakeActor(prop, Look()));
  }
  renderer->ResetCameraInside();
  Vector3 place;
  renderer->GetActiveCamera()->GetPosition(place.data());
  return place;
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
  if (std::any_of(scene.Props.begin(), scene.Props.end(), SurroundsAll))
  {
    return FreePlace(scene);
  }
  const vtkSmartPointer<vtkPolyData> sides = Sides(scene);
  if (!sides)
  {
    return std::nullopt;
  }
  Looker looker(sides, b);
  const std::vector<Vector3> places = SurroundedPlaces(looker, middle, size);
  if (places.empty() || places.front() == middle)
  {
    return places.empty() ? std::nullopt : std::optional(middle);
  }
  return *std::max_element(places.begin(), places.end(), [&](const Vector3& a, const Vector3& b) {
    return looker.SquaredDistance(a) < looker.SquaredDistance(b);
  });
}
}
