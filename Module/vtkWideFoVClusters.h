// SPDX-License-Identifier: BSD-3-Clause
// The triangles of a polydata as its mapper draws them, in runs of neighbours with their bounds.
#ifndef vtkWideFoVClusters_h
#define vtkWideFoVClusters_h

#include "vtkType.h"

#include <array>
#include <vector>

class vtkCellArray;
class vtkPoints;
class vtkPolyData;

namespace wfv
{
// Runs keep the order of the triangles: meshes come in an order that keeps neighbours together,
// and the numbers of the triangles stay theirs.
class Clusters
{
public:
  static constexpr int Size = 128; // triangles a cluster; the last one has fewer

  // strips: of the triangle strips; else of the polygons.
  explicit Clusters(bool strips)
    : Strips(strips)
  {
  }

  // Makes them anew where the data have changed.
  void Update(vtkPolyData* data);

  // The cells that they are of.
  vtkCellArray* GetCells(vtkPolyData* data) const;

  vtkIdType GetNumberOfTriangles() const
  {
    return static_cast<vtkIdType>(this->Corners.size() / 3);
  }
  int GetNumberOfClusters() const { return static_cast<int>(this->Bounds.size()); }

  // xmin, xmax, ymin, ymax, zmin, zmax; infinite where a point is no number.
  const std::array<double, 6>& GetBounds(int cluster) const { return this->Bounds[cluster]; }

  // Points of the triangles, three each: what the mapper's index buffer holds.
  const std::vector<unsigned int>& GetCorners() const { return this->Corners; }

  // For each edge of each triangle, from corner j to the next, the triangle on its other side;
  // NoTriangle where there is none, more than one, or one that is turned the other way. Points at
  // one place are one. Found when it is first asked for.
  static constexpr unsigned int NoTriangle = ~0u;
  const std::vector<unsigned int>& GetNeighbours();

  // For each point the first one at its place; found when it is first asked for.
  const std::vector<unsigned int>& GetPlaces();

private:
  void Build(vtkPolyData* data);
  void Add(vtkPoints* points, const vtkIdType corners[3]);

  const bool Strips;

  vtkPolyData* Data = nullptr; // compared; used by those who have just updated
  vtkMTimeType Time = 0;
  std::vector<unsigned int> Corners;
  std::vector<unsigned int> Neighbours;
  std::vector<unsigned int> Places;
  std::vector<std::array<double, 6>> Bounds;
};
}

#endif
