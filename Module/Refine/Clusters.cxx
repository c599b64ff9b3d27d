// SPDX-License-Identifier: BSD-3-Clause
#include "Refine/Clusters.h"

#include "vtkAOSDataArrayTemplate.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <atomic>
#include <cmath>

namespace
{
using Place = std::array<double, 3>;

constexpr std::array<double, 6> Nowhere{ VTK_DOUBLE_MAX, -VTK_DOUBLE_MAX, VTK_DOUBLE_MAX,
  -VTK_DOUBLE_MAX, VTK_DOUBLE_MAX, -VTK_DOUBLE_MAX };

Place PlaceOf(vtkPoints* points, vtkIdType id)
{
  Place p;
  points->GetPoint(id, p.data());
  return p;
}

double SquaredDistance(const Place& p, const Place& q)
{
  return (p[0] - q[0]) * (p[0] - q[0]) + (p[1] - q[1]) * (p[1] - q[1]) +
    (p[2] - q[2]) * (p[2] - q[2]);
}

void Extend(std::array<double, 6>& bounds, const Place& p)
{
  for (int i = 0; i < 3; i++)
  {
    const bool finite = std::isfinite(p[i]);
    bounds[2 * i] = finite ? std::min(bounds[2 * i], p[i]) : -VTK_DOUBLE_MAX;
    bounds[2 * i + 1] = finite ? std::max(bounds[2 * i + 1], p[i]) : VTK_DOUBLE_MAX;
  }
}

bool IsCollapsed(const Place& p, const Place& q, const Place& r)
{
  return p == q || q == r || r == p;
}
}

namespace wfv
{
bool Corners::Take(vtkCellArray* cells)
{
  vtkDataArray* const ids = cells->GetConnectivityArray();
  auto* const wide = vtkAOSDataArrayTemplate<vtkTypeInt64>::FastDownCast(ids);
  auto* const narrow = vtkAOSDataArrayTemplate<vtkTypeInt32>::FastDownCast(ids);
  this->Wide = wide ? wide->GetPointer(0) : nullptr;
  // (none is below 0)
  this->Narrow = narrow ? reinterpret_cast<const unsigned int*>(narrow->GetPointer(0)) : nullptr;
  this->Size = wide || narrow ? static_cast<std::size_t>(ids->GetNumberOfValues()) : 0;
  return wide || narrow;
}

void Corners::Take(const std::vector<unsigned int>& copy)
{
  this->Wide = nullptr;
  this->Narrow = copy.data();
  this->Size = copy.size();
}

void Clusters::Update(vtkPolyData* data)
{
  vtkPoints* const points = data->GetPoints();
  vtkCellArray* const cells = this->GetCells(data);
  const vtkIdType sizes[2] = { points ? points->GetNumberOfPoints() : 0,
    cells->GetNumberOfConnectivityIds() };
  if (this->Data != data || this->Time != data->GetMTime() ||
    !std::equal(sizes, sizes + 2, this->Sizes))
  {
    this->Data = data;
    this->Time = data->GetMTime();
    std::copy_n(sizes, 2, this->Sizes);
    this->Build(data);
  }
  else if (this->AsTheyAre)
  {
    this->All.Take(cells); // wherever they are now
  }
}

vtkCellArray* Clusters::GetCells(vtkPolyData* data) const
{
  return this->Strips ? data->GetStrips() : data->GetPolys();
}

void Clusters::Build(vtkPolyData* data)
{
  this->Copy.clear();
  this->Bounds.clear();
  this->Edges.clear();
  this->All = Corners();
  this->Triangles = 0;
  this->AsTheyAre = false;
  vtkCellArray* const cells = this->GetCells(data);
  vtkPoints* const points = data->GetPoints();
  if (!points)
  {
    return;
  }
  if (!this->Strips && cells->IsHomogeneous() == 3 && this->All.Take(cells))
  {
    this->AsTheyAre = this->Measure(points);
  }
  if (!this->AsTheyAre)
  {
    this->CopyCorners(data);
    this->All.Take(this->Copy);
    this->Measure(points);
  }
}

// As vtkOpenGLIndexBufferObject does: polygons as fans, without triangles of two equal corners;
// every other triangle of a strip turned round.
void Clusters::CopyCorners(vtkPolyData* data)
{
  vtkCellArray* const cells = this->GetCells(data);
  vtkPoints* const points = data->GetPoints();
  // (cells of fewer than three corners have none)
  this->Copy.reserve(std::max<vtkIdType>(
    0, 3 * (cells->GetNumberOfConnectivityIds() - 2 * cells->GetNumberOfCells())));
  auto it = vtk::TakeSmartPointer(cells->NewIterator());
  for (it->GoToFirstCell(); !it->IsDoneWithTraversal(); it->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    it->GetCurrentCell(size, ids);
    for (vtkIdType i = 2; i < size; i++)
    {
      const bool odd = i % 2 != 0;
      const vtkIdType corners[3] = { this->Strips ? ids[i - 2] : ids[0],
        this->Strips && odd ? ids[i] : ids[i - 1], this->Strips && odd ? ids[i - 1] : ids[i] };
      if (this->Strips ||
        !IsCollapsed(
          PlaceOf(points, corners[0]), PlaceOf(points, corners[1]), PlaceOf(points, corners[2])))
      {
        this->Copy.insert(this->Copy.end(), corners, corners + 3);
      }
    }
  }
}

bool Clusters::Measure(vtkPoints* points)
{
  if (auto* const singles = vtkFloatArray::SafeDownCast(points->GetData()))
  {
    const float* const p = singles->GetPointer(0);
    return this->MeasurePlaces([p](std::size_t id) {
      return Place{ p[3 * id], p[3 * id + 1], p[3 * id + 2] };
    });
  }
  return this->MeasurePlaces(
    [points](std::size_t id) { return PlaceOf(points, static_cast<vtkIdType>(id)); });
}

template <typename PlaceAt>
bool Clusters::MeasurePlaces(const PlaceAt& placeAt)
{
  this->Triangles = static_cast<vtkIdType>(this->All.size() / 3);
  const vtkIdType clusters = (this->Triangles + Size - 1) / Size;
  this->Bounds.assign(clusters, Nowhere);
  this->Edges.assign(clusters, 0);
  std::atomic<bool> collapsed{ false };
  vtkSMPTools::For(0, clusters, Grain, [&](vtkIdType from, vtkIdType to) {
    for (int c = static_cast<int>(from); c < to; c++)
    {
      double longest = 0; // squared
      for (vtkIdType i = this->GetFirst(c); i < this->GetEnd(c); i++)
      {
        const Place p = placeAt(this->All[3 * i]);
        const Place q = placeAt(this->All[3 * i + 1]);
        const Place r = placeAt(this->All[3 * i + 2]);
        if (IsCollapsed(p, q, r))
        {
          collapsed = true;
        }
        for (const Place& corner : { p, q, r })
        {
          Extend(this->Bounds[c], corner);
        }
        longest = std::max(
          { longest, SquaredDistance(p, q), SquaredDistance(q, r), SquaredDistance(r, p) });
      }
      this->Edges[c] = std::sqrt(longest);
    }
  });
  return !collapsed;
}
}
