// SPDX-License-Identifier: BSD-3-Clause
// What a frame did and left out.
#ifndef vtkWideFoVFrameCounts_h
#define vtkWideFoVFrameCounts_h

#include "vtkType.h"

namespace wfv
{
struct FrameCounts
{
  int Clusters = 0; // runs of triangles
  int UnseenClusters = 0;
  vtkIdType Triangles = 0; // of them
  vtkIdType UnseenTriangles = 0;
  vtkIdType HiddenTriangles = 0; // of the unseen ones, behind others
  int ChosenProps = 0;           // anew
  int SortedMeshes = 0;          // anew

  void Add(const FrameCounts& other)
  {
    this->Clusters += other.Clusters;
    this->UnseenClusters += other.UnseenClusters;
    this->Triangles += other.Triangles;
    this->UnseenTriangles += other.UnseenTriangles;
    this->HiddenTriangles += other.HiddenTriangles;
    this->ChosenProps += other.ChosenProps;
    this->SortedMeshes += other.SortedMeshes;
  }
};
}

#endif
