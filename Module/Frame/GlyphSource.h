// SPDX-License-Identifier: BSD-3-Clause
// The triangles of what a vtkGlyph3DMapper makes copies of, and how many chords stand for their
// edges.
#ifndef WideFoVGlyphSource_h
#define WideFoVGlyphSource_h

#include "Clusters/Clusters.h"

#include <vector>

namespace wfv
{
class GlyphSource
{
public:
  static constexpr int Most = 16; // chords of an edge

  void Update(vtkPolyData* source);

  vtkMTimeType GetTime() const { return this->Time; } // of the data
  vtkIdType GetNumberOfTriangles() const { return this->Mesh.GetNumberOfTriangles(); }
  double GetLongestEdge() const { return this->LongestEdge; }

  // Of the longest edge, that the stage which cuts can make: a power of two; 0 where the source has
  // no triangle.
  int GetMostChords() const { return this->MostChords; }

  // Those of every triangle (common/limits.glsl), where the longest edge has so many.
  std::vector<unsigned int> ListChords(int chords) const;

private:
  int ChordsOf(std::size_t edge, int chords) const;
  bool CanCut(int chords) const;

  Clusters Mesh{ false };
  vtkMTimeType Time = 0;
  std::vector<double> Edges; // of each triangle, opposite to its corners
  double LongestEdge = 0;
  int MostChords = 0;
};
}

#endif
