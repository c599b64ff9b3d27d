// SPDX-License-Identifier: BSD-3-Clause
#include "GridBox.h"

#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkProperty.h"

#include <algorithm>

namespace wfvplugin
{
namespace
{
// A bit of the masks of faces and labels: the minima of x, y and z, then their maxima.
unsigned int BitOf(int axis, int side)
{
  return 1u << (axis + 3 * side);
}

// One of the box's twelve edges, by its axis and the sides that it is at of the two others.
int NumberOf(int axis, int across, int acrossSide, int faceSide)
{
  const bool next = across == (axis + 1) % 3;
  return 4 * axis + (next ? 2 * acrossSide + faceSide : 2 * faceSide + acrossSide);
}

// Calls with the axis of each edge of a face, the axis across it, and the side it is at.
template <typename F>
void ForEdges(const GridFace& face, const F& call)
{
  for (int i = 1; i <= 2; i++)
  {
    for (int side = 0; side <= 1; side++)
    {
      call((face.Axis + i) % 3, (face.Axis + 3 - i) % 3, side);
    }
  }
}
}

GridBox::GridBox(GridAxesActor* actor, const Point3& eye)
  : Matrix(nullptr)
{
  actor->GetBounds(); // which brings the bounds of the grid up to date
  actor->GetGridBounds(this->Bounds.data());
  this->Matrix = actor->GetMatrix();
  if (vtkMath::AreBoundsInitialized(this->Bounds.data()))
  {
    this->FindFaces(actor, eye);
    this->FindEdges(actor);
  }
}

Point3 GridBox::ToWorld(const Point3& point) const
{
  double p[4] = { point[0], point[1], point[2], 1 };
  this->Matrix->MultiplyPoint(p, p);
  return { { p[0] / p[3], p[1] / p[3], p[2] / p[3] } };
}

bool GridBox::IsBack(const GridFace& face, const Point3& eye) const
{
  Point3 middle;
  Point3 center;
  for (int i = 0; i < 3; i++)
  {
    middle[i] = center[i] = 0.5 * (this->GetMinimum(i) + this->GetMaximum(i));
  }
  const auto at = [&](int side) {
    return side ? this->GetMaximum(face.Axis) : this->GetMinimum(face.Axis);
  };
  center[face.Axis] = at(face.Side);
  const Point3 p = this->ToWorld(center);
  const Point3 inside = this->ToWorld(middle);
  Point3 sides[2];
  for (int i = 0; i < 2; i++)
  {
    Point3 other = center;
    other[(face.Axis + 1 + i) % 3] += 0.5 * this->GetSize((face.Axis + 1 + i) % 3);
    other = this->ToWorld(other);
    vtkMath::Subtract(other, p, sides[i]);
  }
  Point3 normal;
  vtkMath::Cross(sides[0].data(), sides[1].data(), normal.data());
  Point3 inwards;
  vtkMath::Subtract(inside, p, inwards);
  Point3 toEye;
  vtkMath::Subtract(eye, p, toEye);
  return vtkMath::Dot(normal.data(), toEye.data()) * vtkMath::Dot(normal.data(), inwards.data()) >=
    0;
}

void GridBox::FindFaces(GridAxesActor* actor, const Point3& eye)
{
  vtkProperty* const property = actor->GetProperty();
  for (int axis = 0; axis < 3; axis++)
  {
    if (this->GetSize((axis + 1) % 3) <= 0 || this->GetSize((axis + 2) % 3) <= 0)
    {
      continue; // of flat data
    }
    const int sides = this->GetSize(axis) > 0 ? 2 : 1;
    for (int side = 0; side < sides; side++)
    {
      const GridFace face{ axis, side };
      const bool back = this->IsBack(face, eye);
      const bool culled =
        back ? property->GetBackfaceCulling() != 0 : property->GetFrontfaceCulling() != 0;
      if ((actor->GetFaceMask() & BitOf(axis, side)) && !culled)
      {
        this->Faces.push_back(face);
      }
    }
  }
}

void GridBox::FindEdges(GridAxesActor* actor)
{
  std::array<int, 12> count{};
  for (const GridFace& face : this->Faces)
  {
    ForEdges(face,
      [&](int axis, int across, int side) { count[NumberOf(axis, across, side, face.Side)]++; });
  }
  // the outline of the box as it is seen; from inside, where there is none, every edge once
  const bool outline = std::find(count.begin(), count.end(), 1) != count.end();
  std::array<bool, 12> done{};
  for (const GridFace& face : this->Faces)
  {
    ForEdges(face, [&](int axis, int across, int side) {
      const int number = NumberOf(axis, across, side, face.Side);
      const bool wanted =
        !actor->GetLabelUniqueEdgesOnly() || (outline ? count[number] == 1 : !done[number]);
      if (wanted && (actor->GetLabelMask() & BitOf(across, side)))
      {
        GridEdge edge{ axis, across, {}, side ? 1.0 : -1.0 };
        edge.From[axis] = this->GetMinimum(axis);
        edge.From[across] = side ? this->GetMaximum(across) : this->GetMinimum(across);
        edge.From[face.Axis] =
          face.Side ? this->GetMaximum(face.Axis) : this->GetMinimum(face.Axis);
        this->Edges.push_back(edge);
        done[number] = true;
      }
    });
  }
}
}
