// SPDX-License-Identifier: BSD-3-Clause
// The triangles of a polydata as its mapper draws them, in runs of neighbours with their bounds.
#ifndef WideFoVClusters_h
#define WideFoVClusters_h

#include "vtkWideFoVAbi.h"

#include "vtkType.h"

#include <algorithm>
#include <array>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkCellArray;
class vtkPoints;
class vtkPolyData;
VTK_ABI_NAMESPACE_END

namespace wfv
{
// The points of triangles, three each: those of cells that are all triangles, where they are, for a
// copy of a large mesh is a tenth of what stock VTK takes for it; else of a copy.
class Corners
{
public:
  unsigned int operator[](std::size_t corner) const
  {
    return this->Wide ? static_cast<unsigned int>(this->Wide[corner]) : this->Narrow[corner];
  }
  std::size_t size() const { return this->Size; }

  // False where these keep them in no plain array of integers, as VTK 9.6 may.
  bool Take(vtkCellArray* triangles);
  void Take(const std::vector<unsigned int>& copy);

private:
  const vtkTypeInt64* Wide = nullptr;
  const unsigned int* Narrow = nullptr;
  std::size_t Size = 0;
};

// Runs keep the order of the triangles: meshes come in an order that keeps neighbours together,
// and the numbers of the triangles stay theirs.
class Clusters
{
public:
  static constexpr int Size = 128;       // triangles a cluster; the last one has fewer
  static constexpr vtkIdType Grain = 64; // clusters a thread takes at least

  // strips: of the triangle strips; else of the polygons.
  explicit Clusters(bool strips)
    : Strips(strips)
  {
  }

  // Makes them anew where the data have changed, or what they need has been let go. To be called
  // before anything is asked for, for corners may be the cells' own.
  void Update(vtkPolyData* data);

  // The cells that they are of.
  vtkCellArray* GetCells(vtkPolyData* data) const;

  vtkIdType GetNumberOfTriangles() const { return this->Triangles; }
  int GetNumberOfClusters() const { return static_cast<int>(this->Bounds.size()); }

  // xmin, xmax, ymin, ymax, zmin, zmax; infinite where a point is no number.
  const std::array<double, 6>& GetBounds(int cluster) const { return this->Bounds[cluster]; }

  // Of the triangles of a cluster, the longest edge.
  double GetLongestEdge(int cluster) const { return this->Edges[cluster]; }

  // The triangles of a cluster: the first, and the one behind the last.
  vtkIdType GetFirst(int cluster) const { return static_cast<vtkIdType>(cluster) * Size; }
  vtkIdType GetEnd(int cluster) const
  {
    return std::min<vtkIdType>(this->GetFirst(cluster) + Size, this->Triangles);
  }

  // Points of the triangles, three each: what the mapper's index buffer holds.
  const Corners& GetCorners() const { return this->All; }

private:
  void Build(vtkPolyData* data);
  void CopyCorners(vtkPolyData* data);

  // By VTK's threads. False where two corners of a triangle are at one place.
  bool Measure(vtkPoints* points);
  template <typename PlaceAt>
  bool MeasurePlaces(const PlaceAt& placeAt);

  const bool Strips;

  vtkPolyData* Data = nullptr; // compared; used by those who have just updated
  vtkMTimeType Time = 0;
  vtkIdType Sizes[2] = { 0, 0 }; // of points and of the points of cells
  vtkIdType Triangles = 0;
  bool AsTheyAre = false; // the cells are the triangles, one each
  Corners All;
  std::vector<unsigned int> Copy; // unless they are
  std::vector<std::array<double, 6>> Bounds;
  std::vector<double> Edges;
};
}

#endif
