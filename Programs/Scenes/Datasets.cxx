// SPDX-License-Identifier: BSD-3-Clause
#include "Datasets.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCellDataToPointData.h>
#include <vtkCellTypes.h>
#include <vtkCompositeDataGeometryFilter.h>
#include <vtkCompositeDataIterator.h>
#include <vtkCompositeDataSet.h>
#include <vtkDataSetSurfaceFilter.h>
#include <vtkGenericCell.h>
#include <vtkImageData.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkRectilinearGrid.h>
#include <vtkStructuredGrid.h>

#include "Compat/Renamed.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace widefov
{
namespace
{
constexpr double LargestCoordinate = 1e18;

vtkSmartPointer<vtkPolyData> WithVertices(vtkPolyData* data)
{
  if (data->GetNumberOfCells() > 0 || data->GetNumberOfPoints() == 0)
  {
    return data;
  }
  vtkNew<vtkPolyData> result;
  result->ShallowCopy(data);
  vtkNew<vtkCellArray> vertices;
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); i++)
  {
    vertices->InsertNextCell(1, &i);
  }
  result->SetVerts(vertices);
  return result;
}

std::vector<bool> UsablePoints(vtkPolyData* data, vtkIdType& unusable)
{
  std::vector<bool> usable(static_cast<std::size_t>(data->GetNumberOfPoints()));
  unusable = 0;
  for (std::size_t i = 0; i < usable.size(); i++)
  {
    double p[3];
    data->GetPoint(static_cast<vtkIdType>(i), p);
    usable[i] = std::abs(p[0]) <= LargestCoordinate && std::abs(p[1]) <= LargestCoordinate &&
      std::abs(p[2]) <= LargestCoordinate; // false for NaN
    unusable += usable[i] ? 0 : 1;
  }
  return usable;
}

// The points with every unusable one moved onto a usable one, so that bounds are finite.
vtkSmartPointer<vtkPoints> FinitePoints(vtkPolyData* data, const std::vector<bool>& usable)
{
  const auto good = std::find(usable.begin(), usable.end(), true);
  double place[3] = { 0, 0, 0 };
  if (good != usable.end())
  {
    data->GetPoint(good - usable.begin(), place);
  }
  vtkNew<vtkPoints> points;
  points->DeepCopy(data->GetPoints());
  for (std::size_t i = 0; i < usable.size(); i++)
  {
    if (!usable[i])
    {
      points->SetPoint(static_cast<vtkIdType>(i), place);
    }
  }
  return points;
}

// The cells of one kind that use only usable points; the ids of those kept go to `kept`,
// counted from `first`.
vtkSmartPointer<vtkCellArray> UsableCells(vtkCellArray* cells, const std::vector<bool>& usable,
  vtkIdType first, std::vector<vtkIdType>& kept)
{
  vtkNew<vtkCellArray> result;
  for (vtkIdType i = 0; i < cells->GetNumberOfCells(); i++)
  {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    cells->GetCellAtId(i, count, ids);
    const bool good = std::all_of(
      ids, ids + count, [&](vtkIdType id) { return usable[static_cast<std::size_t>(id)]; });
    if (good)
    {
      result->InsertNextCell(count, ids);
      kept.push_back(first + i);
    }
  }
  return result;
}
}

namespace
{
template <class Grid>
bool HasLayers(vtkDataObject* data)
{
  int dimensions[3] = { 1, 1, 1 };
  if (auto* const grid = Grid::SafeDownCast(data))
  {
    grid->GetDimensions(dimensions);
  }
  return dimensions[0] > 1 && dimensions[1] > 1 && dimensions[2] > 1;
}

bool IsGrid(vtkDataSet* data)
{
  return HasLayers<vtkStructuredGrid>(data) || HasLayers<vtkRectilinearGrid>(data);
}

bool HasBodies(vtkDataSet* data)
{
  vtkNew<vtkCellTypes> types;
  wfv::FindCellTypes(data, types);
  for (vtkIdType i = 0; i < types->GetNumberOfTypes(); i++)
  {
    vtkNew<vtkGenericCell> cell;
    cell->SetCellType(types->GetCellType(i));
    if (cell->GetCellDimension() == 3)
    {
      return true;
    }
  }
  return false;
}
}

std::vector<vtkSmartPointer<vtkDataSet>> Leaves(vtkDataObject* data)
{
  std::vector<vtkSmartPointer<vtkDataSet>> leaves;
  if (vtkDataSet* const single = vtkDataSet::SafeDownCast(data))
  {
    leaves.emplace_back(single);
  }
  if (vtkCompositeDataSet* const composite = vtkCompositeDataSet::SafeDownCast(data))
  {
    vtkSmartPointer<vtkCompositeDataIterator> it;
    it.TakeReference(composite->NewIterator());
    for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
    {
      vtkDataSet* const leaf = vtkDataSet::SafeDownCast(it->GetCurrentDataObject());
      if (leaf != nullptr && leaf->GetNumberOfPoints() > 0)
      {
        leaves.emplace_back(leaf);
      }
    }
  }
  return leaves;
}

namespace
{
// Names and numbers of components of the arrays, in any order.
using ArraySet = std::set<std::pair<std::string, int>>;

ArraySet ArraysOf(vtkDataSetAttributes* attributes)
{
  ArraySet arrays;
  for (int i = 0; i < attributes->GetNumberOfArrays(); i++)
  {
    vtkAbstractArray* const array = attributes->GetAbstractArray(i);
    arrays.emplace(array->GetName() ? array->GetName() : "", array->GetNumberOfComponents());
  }
  return arrays;
}
}

std::vector<vtkSmartPointer<vtkDataObject>> PartsByArrays(vtkDataObject* data)
{
  std::map<std::pair<ArraySet, ArraySet>, std::size_t> known;
  std::vector<vtkSmartPointer<vtkMultiBlockDataSet>> parts;
  const bool composite = vtkCompositeDataSet::SafeDownCast(data) != nullptr;
  for (const auto& leaf : composite ? Leaves(data) : std::vector<vtkSmartPointer<vtkDataSet>>())
  {
    const auto arrays = std::pair(ArraysOf(leaf->GetPointData()), ArraysOf(leaf->GetCellData()));
    const std::size_t part = known.emplace(arrays, parts.size()).first->second;
    if (part == parts.size())
    {
      parts.push_back(vtkSmartPointer<vtkMultiBlockDataSet>::New());
    }
    parts[part]->SetBlock(parts[part]->GetNumberOfBlocks(), leaf);
  }
  if (parts.size() < 2)
  {
    return { data };
  }
  return { parts.begin(), parts.end() };
}

bool IsSpatialImage(vtkDataObject* data)
{
  auto* const image = vtkImageData::SafeDownCast(data);
  const double* const spacing = image != nullptr ? image->GetSpacing() : nullptr;
  return HasLayers<vtkImageData>(data) && spacing[0] > 0 && spacing[1] > 0 && spacing[2] > 0;
}

bool IsSpatialGrid(vtkDataObject* data)
{
  const std::vector<vtkSmartPointer<vtkDataSet>> leaves = Leaves(data);
  return std::any_of(leaves.begin(), leaves.end(), [](vtkDataSet* leaf) { return IsGrid(leaf); });
}

bool FillsSpace(vtkDataObject* data)
{
  const std::vector<vtkSmartPointer<vtkDataSet>> leaves = Leaves(data);
  return std::any_of(leaves.begin(), leaves.end(), [](vtkDataSet* leaf) {
    return IsGrid(leaf) || IsSpatialImage(leaf) ||
      (vtkPolyData::SafeDownCast(leaf) == nullptr && HasBodies(leaf));
  });
}

vtkSmartPointer<vtkPolyData> SurfaceOf(vtkDataObject* data)
{
  if (vtkPolyData* const surface = vtkPolyData::SafeDownCast(data))
  {
    return WithVertices(surface);
  }
  if (vtkCompositeDataSet::SafeDownCast(data) != nullptr)
  {
    vtkNew<vtkCompositeDataGeometryFilter> filter;
    filter->SetInputDataObject(data);
    filter->Update();
    return WithVertices(filter->GetOutput());
  }
  vtkNew<vtkDataSetSurfaceFilter> filter;
  filter->SetInputDataObject(data);
  filter->Update();
  vtkPolyData* const surface = filter->GetOutput();
  vtkDataSet* const set = vtkDataSet::SafeDownCast(data);
  if (surface->GetNumberOfCells() > 0 || set == nullptr || set->GetNumberOfPoints() == 0)
  {
    return surface;
  }
  vtkNew<vtkPolyData> cloud; // points alone
  vtkNew<vtkPoints> points;
  points->SetNumberOfPoints(set->GetNumberOfPoints());
  for (vtkIdType i = 0; i < set->GetNumberOfPoints(); i++)
  {
    points->SetPoint(i, set->GetPoint(i));
  }
  cloud->SetPoints(points);
  cloud->GetPointData()->ShallowCopy(set->GetPointData());
  return WithVertices(cloud);
}

vtkSmartPointer<vtkDataObject> PointVectors(vtkDataObject* data, const std::string& array)
{
  for (const auto& leaf : Leaves(data))
  {
    if (leaf->GetPointData()->GetArray(array.c_str()) != nullptr)
    {
      return data;
    }
  }
  vtkNew<vtkCellDataToPointData> average;
  average->SetInputDataObject(data);
  average->Update();
  return average->GetOutputDataObject(0);
}

CleanResult DropUnusableCells(vtkPolyData* data)
{
  vtkIdType unusable = 0;
  const std::vector<bool> usable = UsablePoints(data, unusable);
  if (unusable == 0)
  {
    return { data, 0 };
  }
  vtkNew<vtkPolyData> clean;
  clean->SetPoints(FinitePoints(data, usable));
  clean->GetPointData()->ShallowCopy(data->GetPointData());
  // cell data are ordered: vertices, lines, polygons, strips
  std::vector<vtkIdType> kept;
  vtkIdType first = 0;
  const auto take = [&](vtkCellArray* cells) {
    const vtkIdType start = first;
    first += cells->GetNumberOfCells();
    return UsableCells(cells, usable, start, kept);
  };
  clean->SetVerts(take(data->GetVerts()));
  clean->SetLines(take(data->GetLines()));
  clean->SetPolys(take(data->GetPolys()));
  clean->SetStrips(take(data->GetStrips()));
  clean->GetCellData()->CopyAllocate(data->GetCellData());
  for (std::size_t i = 0; i < kept.size(); i++)
  {
    clean->GetCellData()->CopyData(data->GetCellData(), kept[i], static_cast<vtkIdType>(i));
  }
  return { clean, first - static_cast<vtkIdType>(kept.size()) };
}

std::vector<std::string> ArrayNames(vtkDataObject* data)
{
  std::vector<std::string> names;
  const auto add = [&names](vtkDataSetAttributes* attributes) {
    for (int i = 0; i < attributes->GetNumberOfArrays(); i++)
    {
      const char* const name = attributes->GetArrayName(i);
      if (name != nullptr && attributes->GetArray(i) != nullptr &&
        std::find(names.begin(), names.end(), name) == names.end())
      {
        names.emplace_back(name);
      }
    }
  };
  for (const auto& leaf : Leaves(data))
  {
    add(leaf->GetPointData());
  }
  for (const auto& leaf : Leaves(data))
  {
    add(leaf->GetCellData());
  }
  return names;
}
}
