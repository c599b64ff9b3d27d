// SPDX-License-Identifier: BSD-3-Clause
// A triangulation of the sphere that is refined at random and stays one: every direction
// from the origin meets exactly one triangle, or an edge or a vertex of several.
#ifndef WideFoVStressSphere_h
#define WideFoVStressSphere_h

#include "Random.h"

#include <vtkType.h>

#include <array>
#include <map>
#include <vector>

namespace wfv
{
namespace stress
{
class SphereMesh
{
public:
  // An octahedron with its vertices on the axes. Distances of vertices are random in
  // [1, mostRadius]; no triangle gets thinner than `thinnest`: the volume that it spans with
  // the origin, relative to the product of its vertices' distances. Nothing comes nearer to
  // the origin than LeastDistance.
  static constexpr double LeastDistance = 0.2;
  SphereMesh(Random& random, double mostRadius, double thinnest);

  // Adds a vertex inside a triangle or on an edge, or turns an edge. Nothing changes where
  // a triangle would become too thin or turn over.
  void Refine(Random& random);

  int GetCount() const { return int(this->Triangles.size()); }
  const std::vector<vec3>& GetPoints() const { return this->Points; } // float32 numbers
  const std::vector<std::array<vtkIdType, 3>>& GetTriangles() const { return this->Triangles; }

  // The measure that `thinnest` bounds; negative where the triangle faces the origin the
  // wrong way round.
  double Thickness(const std::array<vtkIdType, 3>& triangle) const;

private:
  using Ids = std::array<vtkIdType, 3>;
  vtkIdType AddPoint(Random& random, const vec3& direction);
  std::size_t FindTriangle(const vec3& direction) const;
  bool Replace(const std::vector<std::size_t>& old, const std::vector<Ids>& fresh);
  void SplitFace(Random& random, std::size_t triangle);
  void SplitEdge(Random& random, std::size_t triangle);
  void TurnEdge(std::size_t triangle, int edge);
  std::size_t Across(std::size_t triangle, int edge) const;
  vtkIdType Apex(std::size_t triangle, vtkIdType a, vtkIdType b) const;

  double MostRadius;
  double Thinnest;
  std::vector<vec3> Points;
  std::vector<Ids> Triangles;
  std::map<std::pair<vtkIdType, vtkIdType>, std::size_t> Edges; // directed edge to triangle
};
}
}

#endif
