// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWideFoVClusters.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace
{
using Place = std::array<double, 3>;

Place PlaceOf(vtkPoints* points, vtkIdType id)
{
  Place p;
  points->GetPoint(id, p.data());
  return p;
}

std::size_t Mixed(std::size_t hash, std::size_t more)
{
  hash = (hash ^ more) * 0x9E3779B97F4A7C15ull; // 2^64 over the golden ratio
  return hash ^ (hash >> 32);
}

std::size_t HashOf(const Place& p)
{
  const std::hash<double> hash;
  return Mixed(Mixed(Mixed(0, hash(p[0])), hash(p[1])), hash(p[2]));
}

// A table of numbers by the hashes of what they stand for, at most half full.
std::vector<unsigned int> MakeTable(std::size_t entries)
{
  std::size_t size = 16;
  while (size < 2 * entries)
  {
    size *= 2;
  }
  return std::vector<unsigned int>(size, wfv::Clusters::NoTriangle);
}

// For each point the first one at its place.
std::vector<unsigned int> FindPlaces(vtkPoints* points)
{
  const auto n = static_cast<std::size_t>(points->GetNumberOfPoints());
  std::vector<unsigned int> table = MakeTable(n);
  std::vector<unsigned int> places(n);
  for (std::size_t i = 0; i < n; i++)
  {
    const Place p = PlaceOf(points, static_cast<vtkIdType>(i));
    std::size_t at = HashOf(p) & (table.size() - 1);
    while (table[at] != wfv::Clusters::NoTriangle && PlaceOf(points, table[at]) != p)
    {
      at = (at + 1) & (table.size() - 1);
    }
    table[at] = std::min(table[at], static_cast<unsigned int>(i));
    places[i] = table[at];
  }
  return places;
}

// Finds the triangles on the two sides of edges; the edge 3 i + j is that of triangle i from its
// corner j.
class EdgeLinks
{
public:
  EdgeLinks(const std::vector<unsigned int>& corners, const std::vector<unsigned int>& places)
    : Corners(corners)
    , Places(places)
    , Table(MakeTable(corners.size()))
    , Links(corners.size(), None)
  {
  }

  // For each edge the triangle beyond.
  std::vector<unsigned int> Find()
  {
    for (unsigned int edge = 0; edge < this->Corners.size(); edge++)
    {
      const unsigned int first = this->Enter(edge);
      if (first == edge)
      {
        continue;
      }
      const bool pair = this->Links[first] == None && this->From(first) == this->To(edge);
      if (pair)
      {
        this->Links[first] = edge;
        this->Links[edge] = first;
        continue;
      }
      // a third one, or one that is turned the other way: none of them has a neighbour there
      const unsigned int second = this->Links[first];
      if (second != None && second != Many)
      {
        this->Links[second] = Many;
      }
      this->Links[first] = this->Links[edge] = Many;
    }
    for (unsigned int& link : this->Links)
    {
      link = link >= Many ? None : link / 3;
    }
    return std::move(this->Links);
  }

private:
  static constexpr unsigned int None = wfv::Clusters::NoTriangle;
  static constexpr unsigned int Many = None - 1;

  unsigned int From(unsigned int edge) const { return this->Places[this->Corners[edge]]; }
  unsigned int To(unsigned int edge) const
  {
    return this->Places[this->Corners[edge % 3 == 2 ? edge - 2 : edge + 1]];
  }

  bool Same(unsigned int a, unsigned int b) const
  {
    return (this->From(a) == this->From(b) && this->To(a) == this->To(b)) ||
      (this->From(a) == this->To(b) && this->To(a) == this->From(b));
  }

  // The first edge between these two places, this one where there is none before it.
  unsigned int Enter(unsigned int edge)
  {
    const unsigned int a = this->From(edge);
    const unsigned int b = this->To(edge);
    const std::size_t mask = this->Table.size() - 1;
    std::size_t at = Mixed(Mixed(0, std::min(a, b)), std::max(a, b)) & mask;
    while (this->Table[at] != None && !this->Same(this->Table[at], edge))
    {
      at = (at + 1) & mask;
    }
    this->Table[at] = this->Table[at] == None ? edge : this->Table[at];
    return this->Table[at];
  }

  const std::vector<unsigned int>& Corners;
  const std::vector<unsigned int>& Places;
  std::vector<unsigned int> Table;
  std::vector<unsigned int> Links;
};

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
void Clusters::Update(vtkPolyData* data)
{
  if (this->Data == data && this->Time == data->GetMTime())
  {
    return;
  }
  this->Data = data;
  this->Time = data->GetMTime();
  this->Corners.clear();
  this->Neighbours.clear();
  this->Places.clear();
  this->Bounds.clear();
  if (data->GetPoints())
  {
    this->Build(data);
  }
}

vtkCellArray* Clusters::GetCells(vtkPolyData* data) const
{
  return this->Strips ? data->GetStrips() : data->GetPolys();
}

// As vtkOpenGLIndexBufferObject does: polygons as fans, without triangles of two equal corners;
// every other triangle of a strip turned round.
void Clusters::Build(vtkPolyData* data)
{
  vtkPoints* const points = data->GetPoints();
  vtkCellArray* const cells = this->GetCells(data);
  this->Corners.reserve(3 * (cells->GetNumberOfConnectivityIds() - 2 * cells->GetNumberOfCells()));
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
      this->Add(points, corners);
    }
  }
}

void Clusters::Add(vtkPoints* points, const vtkIdType corners[3])
{
  const Place p[3] = { PlaceOf(points, corners[0]), PlaceOf(points, corners[1]),
    PlaceOf(points, corners[2]) };
  if (!this->Strips && (p[0] == p[1] || p[1] == p[2] || p[2] == p[0]))
  {
    return;
  }
  if (this->Corners.size() % (3 * Size) == 0)
  {
    this->Bounds.push_back({ { VTK_DOUBLE_MAX, -VTK_DOUBLE_MAX, VTK_DOUBLE_MAX, -VTK_DOUBLE_MAX,
      VTK_DOUBLE_MAX, -VTK_DOUBLE_MAX } });
  }
  for (int c = 0; c < 3; c++)
  {
    this->Corners.push_back(static_cast<unsigned int>(corners[c]));
    Extend(this->Bounds.back(), p[c]);
  }
}

const std::vector<unsigned int>& Clusters::GetPlaces()
{
  if (this->Places.empty() && !this->Corners.empty())
  {
    this->Places = FindPlaces(this->Data->GetPoints());
  }
  return this->Places;
}

const std::vector<unsigned int>& Clusters::GetNeighbours()
{
  if (this->Neighbours.empty() && !this->Corners.empty())
  {
    this->Neighbours = EdgeLinks(this->Corners, this->GetPlaces()).Find();
  }
  return this->Neighbours;
}
}
