// SPDX-License-Identifier: BSD-3-Clause
// Which triangles of a mesh a view need not draw, and which of them the vertex stage alone.
#ifndef vtkWideFoVSorter_h
#define vtkWideFoVSorter_h

#include "vtkWideFoVClusters.h"
#include "vtkWideFoVTriangleJudge.h"

#include <vector>

class vtkPoints;

namespace wfv
{
// Every triangle is unseen (outside the picture, or between its samples), plain (its chords are as
// near to its edges as a rasterizer can tell, it meets no discontinuity and touches no outline) or
// has to be covered. Plain ones beside a
// covered one are drawn both ways: so every edge is drawn by both its neighbours as a chord, or by
// both as it is, and no sample between the two is left out.
class Sorter
{
public:
  // The triangles of the clusters, whose points these are; toMap: row-major matrix from their
  // coordinates to the map's own frame. Returns false where the kind of points is not known.
  bool Sort(Clusters& clusters, vtkPoints* points, const double toMap[16], const SortView& view);

  // Numbers of triangles: those to be covered first, calm ones after the others; then the plain
  // ones. A few are both.
  const std::vector<unsigned int>& GetOrder() const { return this->Order; }
  std::size_t GetNumberOfCovered() const { return this->Covered; }
  std::size_t GetNumberOfCalm() const { return this->Calm; }

  // Pixels that an edge of a calm triangle may be off its chord, over its angle squared.
  double GetBend() const { return this->Bend; }

  // Of clusters, those that nothing is drawn of.
  int GetNumberOfUnseen() const { return this->Unseen; }

private:
  void CoverOutlines(Clusters& clusters);
  void SpreadCovered(const std::vector<unsigned int>& neighbours);
  void MakeOrder();

  std::vector<unsigned char> Kinds; // one a triangle
  std::vector<float> Bends;         // of the calm triangles of a cluster, the largest
  std::vector<unsigned char> Marks; // one a point: which sides of triangles are seen round it
  std::vector<unsigned int> Order;
  std::size_t Covered = 0; // not calm
  std::size_t Calm = 0;
  double Bend = 0;
  int Unseen = 0;
};
}

#endif
