// SPDX-License-Identifier: BSD-3-Clause
// The box of an axes grid in the world: which of its faces are drawn, and which edges are labelled.
#ifndef WideFoVPluginGridBox_h
#define WideFoVPluginGridBox_h

#include "GridAxesActor.h"

#include <array>
#include <vector>

class vtkMatrix4x4;

namespace wfvplugin
{
using Point3 = std::array<double, 3>;

struct GridFace
{
  int Axis; // across the face
  int Side; // 0 where that axis is at its minimum, 1 at its maximum
};

// An edge that is labelled, of one of the faces that are drawn.
struct GridEdge
{
  int Axis;    // along the edge
  int Across;  // in the face, across the edge
  Point3 From; // in the grid's coordinates, where its own axis is at its minimum
  double Sign; // of the direction along Across that leads out of the face
};

class GridBox
{
public:
  // As the actor has it, seen from the eye (world).
  GridBox(GridAxesActor* actor, const Point3& eye);

  const std::vector<GridFace>& GetFaces() const { return this->Faces; }
  const std::vector<GridEdge>& GetEdges() const { return this->Edges; }

  double GetMinimum(int axis) const { return this->Bounds[2 * axis]; }
  double GetMaximum(int axis) const { return this->Bounds[2 * axis + 1]; }
  double GetSize(int axis) const { return this->GetMaximum(axis) - this->GetMinimum(axis); }

  // Of a point in the grid's coordinates.
  Point3 ToWorld(const Point3& point) const;

private:
  bool IsBack(const GridFace& face, const Point3& eye) const;
  void FindFaces(GridAxesActor* actor, const Point3& eye);
  void FindEdges(GridAxesActor* actor);

  std::array<double, 6> Bounds;
  vtkMatrix4x4* Matrix;
  std::vector<GridFace> Faces;
  std::vector<GridEdge> Edges;
};
}

#endif
