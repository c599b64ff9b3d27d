// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWideFoVClusters.h"

#include "vtkAOSDataArrayTemplate.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkDataArray.h"
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

constexpr unsigned int None = wfv::Clusters::NoTriangle;

// Where chains of numbers with one hash begin: half as many as there are numbers, or more. Who owns
// the numbers keeps what comes next in a chain, so that nothing else is kept of each.
std::vector<unsigned int> MakeHeads(std::size_t numbers)
{
  std::size_t size = 16;
  while (2 * size < numbers)
  {
    size *= 2;
  }
  return std::vector<unsigned int>(size, None);
}

// For each point the first one at its place.
std::vector<unsigned int> FindPlaces(vtkPoints* points)
{
  const auto n = static_cast<std::size_t>(points->GetNumberOfPoints());
  std::vector<unsigned int> heads = MakeHeads(n);
  std::vector<unsigned int> places(n); // of the first ones, the next in the chain
  std::vector<bool> isFirst(n);
  for (std::size_t i = 0; i < n; i++)
  {
    const Place p = PlaceOf(points, static_cast<vtkIdType>(i));
    unsigned int& head = heads[HashOf(p) & (heads.size() - 1)];
    unsigned int at = head;
    while (at != None && PlaceOf(points, at) != p)
    {
      at = places[at];
    }
    isFirst[i] = at == None;
    places[i] = isFirst[i] ? head : at;
    head = isFirst[i] ? static_cast<unsigned int>(i) : head;
  }
  for (std::size_t i = 0; i < n; i++)
  {
    places[i] = isFirst[i] ? static_cast<unsigned int>(i) : places[i];
  }
  return places;
}

// Finds the triangles on the two sides of edges; the edge 3 i + j is that of triangle i from its
// corner j. Large meshes have many: a number an edge is kept, and three bits.
class EdgeLinks
{
public:
  EdgeLinks(const wfv::Corners& corners, const std::vector<unsigned int>& places)
    : Corners(corners)
    , Places(places)
    , Heads(MakeHeads(corners.size()))
    , Links(corners.size(), None)
    , IsFirst(corners.size())
    , HasOther(corners.size())
    , HasMany(corners.size())
  {
  }

  // For each edge the triangle beyond.
  std::vector<unsigned int> Find()
  {
    for (unsigned int edge = 0; edge < this->Links.size(); edge++)
    {
      const unsigned int first = this->Enter(edge);
      if (first != edge)
      {
        // a third one, or one that is turned the other way: none of them has a neighbour there
        const bool pair = !this->HasOther[first] && this->From(first) == this->To(edge);
        this->HasMany[first] = this->HasMany[first] || !pair;
        this->HasOther[first] = true;
      }
    }
    this->Heads = std::vector<unsigned int>();
    for (unsigned int edge = 0; edge < this->Links.size(); edge++)
    {
      const unsigned int first = this->Links[edge];
      const bool pair = !this->IsFirst[edge] && !this->HasMany[first];
      this->Links[edge] = pair ? first / 3 : None;
      if (pair)
      {
        this->Links[first] = edge / 3;
      }
    }
    return std::move(this->Links);
  }

private:
  unsigned int From(unsigned int edge) const { return this->Places[this->Corners[edge]]; }
  unsigned int To(unsigned int edge) const
  {
    return this->Places[this->Corners[edge % 3 == 2 ? edge - 2 : edge + 1]];
  }

  // The first edge between these two places, this one where there is none before it.
  unsigned int Enter(unsigned int edge)
  {
    const unsigned int a = this->From(edge);
    const unsigned int b = this->To(edge);
    // along a mesh ends are mostly as far from each other as before: so what is met next is near in
    // memory, while the edges of one place are spread
    const std::size_t hash = std::min(a, b) + Mixed(0, std::max(a, b) - std::min(a, b));
    unsigned int& head = this->Heads[hash & (this->Heads.size() - 1)];
    const auto isSame = [&](unsigned int from, unsigned int to) {
      return (from == a && to == b) || (from == b && to == a);
    };
    unsigned int at = head;
    while (at != None && !isSame(this->From(at), this->To(at)))
    {
      at = this->Links[at];
    }
    this->IsFirst[edge] = at == None;
    this->Links[edge] = at == None ? head : at;
    head = at == None ? edge : head;
    return at == None ? edge : at;
  }

  const wfv::Corners& Corners;
  const std::vector<unsigned int>& Places;
  std::vector<unsigned int> Heads;
  std::vector<unsigned int> Links; // of first edges the next in the chain, of others the first
  std::vector<bool> IsFirst;
  std::vector<bool> HasOther; // of first edges
  std::vector<bool> HasMany;  // of first edges
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
    this->Neighbours.clear();
    this->Places.clear();
    this->Build(data);
  }
  else if (this->AsTheyAre)
  {
    this->All.Take(cells); // wherever they are now
  }
  else if (this->Triangles > 0 && this->Copy.empty())
  {
    this->Build(data); // it has been let go
  }
}

void Clusters::LetGo()
{
  this->Neighbours = std::vector<unsigned int>();
  this->Copy = std::vector<unsigned int>();
  this->All = Corners();
}

vtkCellArray* Clusters::GetCells(vtkPolyData* data) const
{
  return this->Strips ? data->GetStrips() : data->GetPolys();
}

void Clusters::Build(vtkPolyData* data)
{
  this->Copy.clear();
  this->Bounds.clear();
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
  }
  this->Triangles++;
  for (int c = 0; c < 3; c++)
  {
    if (!this->AsTheyAre)
    {
      this->Copy.push_back(static_cast<unsigned int>(corners[c]));
    }
    Extend(this->Bounds.back(), p[c]);
  }
  return true;
}

const std::vector<unsigned int>& Clusters::GetPlaces()
{
  if (this->Places.empty() && this->Triangles > 0)
  {
    this->Places = FindPlaces(this->Data->GetPoints());
  }
  return this->Places;
}

const std::vector<unsigned int>& Clusters::GetNeighbours()
{
  if (this->Neighbours.empty() && this->Triangles > 0)
  {
    this->Neighbours = EdgeLinks(this->All, this->GetPlaces()).Find();
  }
  return this->Neighbours;
}
}
