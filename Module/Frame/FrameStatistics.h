// SPDX-License-Identifier: BSD-3-Clause
// What a frame of vtkWideFoVPass drew, what it left out, and what it had to do.
#ifndef WideFoVFrameStatistics_h
#define WideFoVFrameStatistics_h

#include "vtkType.h"

namespace wfv
{
struct FrameStatistics
{
  int DrawnProps = 0; // visible ones
  int CulledProps = 0;

  // Draw calls: of what is projected, with the pre-clip, with every triangle ray-tested,
  // tessellated.
  int ProjectedDraws = 0;
  int PreClipDraws = 0;
  int ExactDraws = 0;
  int TessellateDraws = 0;

  // Of 128 triangles. Meshes of less than 256 have none.
  int Clusters = 0;
  int CulledClusters = 0;

  // Of these clusters, and of glyphs; left out with their cluster or copy; and drawn by their
  // chords, as they are or cut into smaller ones, but for props that are projected as a whole. What
  // a geometry stage lets fall is not known here.
  vtkIdType Triangles = 0;
  vtkIdType CulledTriangles = 0;
  vtkIdType ProjectedTriangles = 0;

  // Pieces of the triangles that are not drawn as they are.
  vtkIdType Pieces = 0;

  // What could not be kept from the frame before: actors whose stage was chosen, meshes whose
  // clusters were classified. 0 where nothing has changed.
  int ChosenProps = 0;
  int ClassifiedMeshes = 0;

  // Seconds that the refinement of meshes, lines and copies took in this frame; 0 if nothing
  // changed.
  double RefineTime = 0;

  // Of all frames so far: shader programs that were made, the seconds that it took to write their
  // text and to make them, each when it is first needed, and those for clusters, once a mesh. Some
  // drivers finish a program only when it is first drawn with; that is not in ShaderTime.
  int MadePrograms = 0;
  double ShaderTime = 0;
  double ClusterTime = 0;

  // With what a mesh adds to them.
  void Add(const FrameStatistics& mesh)
  {
    this->Clusters += mesh.Clusters;
    this->CulledClusters += mesh.CulledClusters;
    this->Triangles += mesh.Triangles;
    this->CulledTriangles += mesh.CulledTriangles;
    this->ProjectedTriangles += mesh.ProjectedTriangles;
    this->Pieces += mesh.Pieces;
    this->ChosenProps += mesh.ChosenProps;
    this->ClassifiedMeshes += mesh.ClassifiedMeshes;
  }
};
}

#endif
