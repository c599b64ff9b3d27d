// SPDX-License-Identifier: BSD-3-Clause
#include "Clusters/Clusters.h"

#include "vtkAOSDataArrayTemplate.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkDataArray.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>

namespace
{
using Place = std::array<double, 3>;

Place PlaceOf(vtkPoints* points, vtkIdType id)
{
  Place p;
  points->GetPoint(id, p.data());
  return p;
}

double Distance(const Place& p, const Place& q)
{
  return std::sqrt(
    (p[0] - q[0]) * (p[0] - q[0]) + (p[1] - q[1]) * (p[1] - q[1]) + (p[2] - q[2]) * (p[2] - q[2]));
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
  if (!data->GetPoints())
  {
    return;
  }
  this->AsTheyAre = !this->Strips && cells->IsHomogeneous() == 3;
  if (this->AsTheyAre && this->All.Take(cells) && this->AddCells(data))
  {
    return;
  }
  this->All = Corners();
  this->AsTheyAre = false;
  this->Bounds.clear();
  this->Edges.clear();
  this->Triangles = 0;
  this->Copy.reserve(3 * (cells->GetNumberOfConnectivityIds() - 2 * cells->GetNumberOfCells()));
  this->AddCells(data);
  this->All.Take(this->Copy);
}

// As vtkOpenGLIndexBufferObject does: polygons as fans, without triangles of two equal corners;
// every other triangle of a strip turned round. False where such a triangle is in cells that are to
// stay as they are.
bool Clusters::AddCells(vtkPolyData* data)
{
  auto it = vtk::TakeSmartPointer(this->GetCells(data)->NewIterator());
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
      if (!this->Add(data->GetPoints(), corners) && this->AsTheyAre)
      {
        return false;
      }
    }
  }
  return true;
}

bool Clusters::Add(vtkPoints* points, const vtkIdType corners[3])
{
  const Place p[3] = { PlaceOf(points, corners[0]), PlaceOf(points, corners[1]),
    PlaceOf(points, corners[2]) };
  if (!this->Strips && (p[0] == p[1] || p[1] == p[2] || p[2] == p[0]))
  {
    return false;
  }
  if (this->Triangles % Size == 0)
  {
    this->Bounds.push_back({ { VTK_DOUBLE_MAX, -VTK_DOUBLE_MAX, VTK_DOUBLE_MAX, -VTK_DOUBLE_MAX,
      VTK_DOUBLE_MAX, -VTK_DOUBLE_MAX } });
    this->Edges.push_back(0);
  }
  this->Triangles++;
  for (int c = 0; c < 3; c++)
  {
    if (!this->AsTheyAre)
    {
      this->Copy.push_back(static_cast<unsigned int>(corners[c]));
    }
    Extend(this->Bounds.back(), p[c]);
    this->Edges.back() = std::max(this->Edges.back(), Distance(p[c], p[(c + 1) % 3]));
  }
  return true;
}
}
