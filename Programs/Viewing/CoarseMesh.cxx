// SPDX-License-Identifier: BSD-3-Clause
#include "CoarseMesh.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace widefov
{
namespace
{
// Cubes along an axis at the most: three numbers of them fit into 63 bits.
constexpr double MostCubes = (1 << 21) - 1;

// The same either way.
std::uint64_t KeyOf(vtkIdType a, vtkIdType b)
{
  return static_cast<std::uint64_t>(std::min(a, b)) << 32 |
    static_cast<std::uint64_t>(std::max(a, b));
}

class Clustering
{
public:
  Clustering(vtkPolyData* from, double size)
    : From(from)
    , Size(size)
  {
    from->GetBounds(this->Bounds);
    for (const double length : { this->Bounds[1] - this->Bounds[0],
           this->Bounds[3] - this->Bounds[2], this->Bounds[5] - this->Bounds[4] })
    {
      this->Size = std::max(this->Size, length / MostCubes);
    }
    this->Points->SetDataType(from->GetPoints()->GetDataType());
    this->To->GetPointData()->CopyAllocate(from->GetPointData());
    this->To->GetCellData()->CopyAllocate(from->GetCellData());
    this->GroupPoints();
  }

  // Cells are numbered by kind: vertices, lines, polygons, strips.
  vtkSmartPointer<vtkPolyData> Run()
  {
    vtkIdType cell = this->From->GetNumberOfVerts();
    this->AddCells(this->From->GetVerts(), 0, &Clustering::AddVertices);
    this->AddCells(this->From->GetLines(), cell, &Clustering::AddSegments);
    cell += this->From->GetNumberOfLines();
    this->AddCells(this->From->GetPolys(), cell, &Clustering::AddFan);
    cell += this->From->GetNumberOfPolys();
    this->AddCells(this->From->GetStrips(), cell, &Clustering::AddStrip);
    this->AddFlat();
    this->To->SetPoints(this->Points);
    this->To->SetVerts(this->Verts);
    this->To->SetLines(this->Lines);
    this->To->SetPolys(this->Polys);
    this->CopyCells();
    return this->To;
  }

private:
  using Adder = void (Clustering::*)(vtkIdType cell, vtkIdType count, const vtkIdType* ids);

  void GroupPoints();
  void AddCells(vtkCellArray* cells, vtkIdType first, Adder add);
  void AddVertices(vtkIdType cell, vtkIdType count, const vtkIdType* ids);
  void AddSegments(vtkIdType cell, vtkIdType count, const vtkIdType* ids);
  void AddFan(vtkIdType cell, vtkIdType count, const vtkIdType* ids);
  void AddStrip(vtkIdType cell, vtkIdType count, const vtkIdType* ids);
  void AddTriangle(vtkIdType cell, vtkIdType a, vtkIdType b, vtkIdType c);
  void AddSegment(vtkIdType cell, vtkIdType a, vtkIdType b);
  void AddFlat();
  void CopyCells();

  vtkPolyData* From;
  double Size;
  double Bounds[6];
  vtkSmartPointer<vtkPolyData> To = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> Points;
  vtkNew<vtkCellArray> Verts;
  vtkNew<vtkCellArray> Lines;
  vtkNew<vtkCellArray> Polys;
  std::vector<vtkIdType> New; // of each point; below 0: it is nowhere
  std::unordered_set<vtkIdType> Single;
  std::unordered_set<std::uint64_t> Segments; // that are there already, also as edges
  std::vector<std::array<vtkIdType, 3>> Flat; // triangles that became lines: cell, ends
  std::array<std::vector<vtkIdType>, 3> Olds; // of the new vertices, lines, polygons
};

void Clustering::GroupPoints()
{
  const vtkIdType count = this->From->GetNumberOfPoints();
  std::unordered_map<std::uint64_t, vtkIdType> byCube;
  this->New.resize(static_cast<std::size_t>(count), -1);
  for (vtkIdType i = 0; i < count; i++)
  {
    double p[3];
    this->From->GetPoint(i, p);
    if (!std::isfinite(p[0] + p[1] + p[2]))
    {
      continue;
    }
    std::uint64_t cube = 0;
    for (int k = 0; k < 3; k++)
    {
      cube = cube << 21 | static_cast<std::uint64_t>((p[k] - this->Bounds[2 * k]) / this->Size);
    }
    const auto [place, first] = byCube.try_emplace(cube, this->Points->GetNumberOfPoints());
    if (first)
    {
      this->To->GetPointData()->CopyData(
        this->From->GetPointData(), i, this->Points->InsertNextPoint(p));
    }
    this->New[static_cast<std::size_t>(i)] = place->second;
  }
}

void Clustering::AddCells(vtkCellArray* cells, vtkIdType first, Adder add)
{
  vtkIdType count = 0;
  const vtkIdType* ids = nullptr;
  std::vector<vtkIdType> own;
  for (vtkIdType i = 0; i < cells->GetNumberOfCells(); i++)
  {
    cells->GetCellAtId(i, count, ids);
    own.resize(static_cast<std::size_t>(count));
    std::transform(ids, ids + count, own.begin(),
      [this](vtkIdType id) { return this->New[static_cast<std::size_t>(id)]; });
    if (count > 0 && *std::min_element(own.begin(), own.end()) >= 0)
    {
      (this->*add)(first + i, count, own.data());
    }
  }
}

void Clustering::AddVertices(vtkIdType cell, vtkIdType count, const vtkIdType* ids)
{
  for (vtkIdType k = 0; k < count; k++)
  {
    if (this->Single.insert(ids[k]).second)
    {
      this->Verts->InsertNextCell(1, ids + k);
      this->Olds[0].push_back(cell);
    }
  }
}

void Clustering::AddSegment(vtkIdType cell, vtkIdType a, vtkIdType b)
{
  if (a != b && this->Segments.insert(KeyOf(a, b)).second)
  {
    const vtkIdType both[2] = { a, b };
    this->Lines->InsertNextCell(2, both);
    this->Olds[1].push_back(cell);
  }
}

void Clustering::AddSegments(vtkIdType cell, vtkIdType count, const vtkIdType* ids)
{
  for (vtkIdType k = 1; k < count; k++)
  {
    this->AddSegment(cell, ids[k - 1], ids[k]);
  }
}

void Clustering::AddTriangle(vtkIdType cell, vtkIdType a, vtkIdType b, vtkIdType c)
{
  if (a == b || b == c || a == c)
  {
    this->Flat.push_back({ cell, a, a == b ? c : b });
    return;
  }
  const vtkIdType corners[3] = { a, b, c };
  this->Polys->InsertNextCell(3, corners);
  this->Olds[2].push_back(cell);
  this->Segments.insert({ KeyOf(a, b), KeyOf(b, c), KeyOf(a, c) });
}

// Where no triangle has such an edge.
void Clustering::AddFlat()
{
  for (const auto& [cell, a, b] : this->Flat)
  {
    this->AddSegment(cell, a, b);
  }
}

void Clustering::AddFan(vtkIdType cell, vtkIdType count, const vtkIdType* ids)
{
  for (vtkIdType k = 2; k < count; k++)
  {
    this->AddTriangle(cell, ids[0], ids[k - 1], ids[k]);
  }
}

void Clustering::AddStrip(vtkIdType cell, vtkIdType count, const vtkIdType* ids)
{
  for (vtkIdType k = 2; k < count; k++)
  {
    const vtkIdType odd = k % 2; // the strip's other side
    this->AddTriangle(cell, ids[k - 2], ids[k - 1 + odd], ids[k - odd]);
  }
}

void Clustering::CopyCells()
{
  vtkIdType next = 0;
  for (const std::vector<vtkIdType>& olds : this->Olds)
  {
    for (const vtkIdType old : olds)
    {
      this->To->GetCellData()->CopyData(this->From->GetCellData(), old, next++);
    }
  }
}
}

vtkSmartPointer<vtkPolyData> MakeCoarse(vtkPolyData* mesh, double size)
{
  if (mesh->GetNumberOfPoints() == 0 || !(size > 0))
  {
    return mesh;
  }
  return Clustering(mesh, size).Run();
}
}
