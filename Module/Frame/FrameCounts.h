// SPDX-License-Identifier: BSD-3-Clause
// What a frame did and left out.
#ifndef WideFoVFrameCounts_h
#define WideFoVFrameCounts_h

#include "vtkType.h"

namespace wfv
{
struct FrameCounts
{
  int Clusters = 0; // of triangles
  int CulledClusters = 0;
  vtkIdType Triangles = 0; // of them
  vtkIdType CulledTriangles = 0;
  vtkIdType ProjectedTriangles = 0; // by their chords
  int ChosenProps = 0;              // anew
  int ClassifiedMeshes = 0;         // anew

  void Add(const FrameCounts& other)
  {
    this->Clusters += other.Clusters;
    this->CulledClusters += other.CulledClusters;
    this->Triangles += other.Triangles;
    this->CulledTriangles += other.CulledTriangles;
    this->ProjectedTriangles += other.ProjectedTriangles;
    this->ChosenProps += other.ChosenProps;
    this->ClassifiedMeshes += other.ClassifiedMeshes;
  }
};
}

#endif
