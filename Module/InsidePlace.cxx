// SPDX-License-Identifier: BSD-3-Clause
#include "InsidePlace.h"

#include "vtkActor.h"
#include "vtkAssemblyNode.h"
#include "vtkAssemblyPath.h"
#include "vtkBoundingBox.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkGenericCell.h"
#include "vtkMapper.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkStaticCellLocator.h"

#include <algorithm>
#include <array>
#include <limits>
#include <memory>
#include <vector>

namespace
{
// Of the bounds' diagonal: as much free space round the middle is enough to stay there.
constexpr double Enough = 0.05;

// Places along each axis, and how far from the middle the outermost are: a share of the bounds.
constexpr int Places = 5;
constexpr double Aside = 0.25;

// A surface where it is drawn.
struct Placed
{
  vtkNew<vtkStaticCellLocator> Locator;
  vtkNew<vtkMatrix4x4> ToWorld;
  vtkNew<vtkMatrix4x4> FromWorld;
};

using Surfaces = std::vector<std::unique_ptr<Placed>>;

void Add(vtkDataObject* data, vtkMatrix4x4* matrix, Surfaces& all)
{
  auto* const surface = vtkPolyData::SafeDownCast(data);
  if (surface && surface->GetNumberOfCells() > 0)
  {
    all.push_back(std::make_unique<Placed>());
    all.back()->Locator->SetDataSet(surface);
    all.back()->Locator->BuildLocator();
    all.back()->ToWorld->DeepCopy(matrix);
    vtkMatrix4x4::Invert(matrix, all.back()->FromWorld);
    return;
  }
  if (auto* const composite = vtkCompositeDataSet::SafeDownCast(data))
  {
    const auto it = vtk::TakeSmartPointer(composite->NewIterator());
    for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
    {
      Add(it->GetCurrentDataObject(), matrix, all);
    }
  }
}

// Of a prop and of what it is made of.
void AddParts(vtkProp* prop, Surfaces& all)
{
  prop->InitPathTraversal();
  while (vtkAssemblyPath* const path = prop->GetNextPath())
  {
    vtkAssemblyNode* const node = path->GetLastNode();
    auto* const actor = vtkActor::SafeDownCast(node->GetViewProp());
    vtkMapper* const mapper = actor ? actor->GetMapper() : nullptr;
    if (mapper && mapper->GetNumberOfInputConnections(0) > 0)
    {
      mapper->Update();
      vtkNew<vtkMatrix4x4> none;
      vtkMatrix4x4* const matrix = node->GetMatrix();
      Add(mapper->GetInputDataObject(0, 0), matrix ? matrix : none.Get(), all);
    }
  }
}

Surfaces SurfacesOf(vtkRenderer* renderer)
{
  Surfaces all;
  vtkPropCollection* const props = renderer->GetViewProps();
  vtkCollectionSimpleIterator it;
  props->InitTraversal(it);
  while (vtkProp* const prop = props->GetNextProp(it))
  {
    if (prop->GetVisibility() && prop->GetUseBounds())
    {
      AddParts(prop, all);
    }
  }
  return all;
}

using Point = std::array<double, 4>;

double SquaredDistance(Surfaces& all, const Point& place)
{
  double least = std::numeric_limits<double>::infinity();
  for (const auto& surface : all)
  {
    Point local;
    Point closest{ { 0, 0, 0, 1 } };
    surface->FromWorld->MultiplyPoint(place.data(), local.data());
    vtkNew<vtkGenericCell> cell;
    vtkIdType id = -1;
    int part = 0;
    double squared = 0;
    surface->Locator->FindClosestPoint(local.data(), closest.data(), cell, id, part, squared);
    surface->ToWorld->MultiplyPoint(closest.data(), closest.data());
    least = std::min(least, vtkMath::Distance2BetweenPoints(place.data(), closest.data()));
  }
  return least;
}

Point PlaceNumber(int number, const double b[6])
{
  Point place{ { 0, 0, 0, 1 } };
  for (std::size_t i = 0; i < 3; ++i)
  {
    const double share = (number % Places) * 2. / (Places - 1) - 1; // -1 to 1
    place[i] = 0.5 * (b[2 * i] + b[2 * i + 1]) + share * Aside * (b[2 * i + 1] - b[2 * i]);
    number /= Places;
  }
  return place;
}
}

void wfv::FindInsidePlace(vtkRenderer* renderer, const double bounds[6], double place[3])
{
  constexpr int All = Places * Places * Places;
  Surfaces surfaces = SurfacesOf(renderer);
  Point best = PlaceNumber(All / 2, bounds); // the middle
  double most = SquaredDistance(surfaces, best);
  const double enough = Enough * vtkBoundingBox(bounds).GetDiagonalLength();
  const bool room = most >= enough * enough;
  for (int i = 0; i < All && !room; ++i)
  {
    const Point other = PlaceNumber(i, bounds);
    const double distance = SquaredDistance(surfaces, other);
    if (distance > most)
    {
      most = distance;
      best = other;
    }
  }
  std::copy(best.begin(), best.begin() + 3, place);
}
