// SPDX-License-Identifier: BSD-3-Clause
// What threads find of the edges of triangles that are covered: where the mesh folds, and what is
// in front there.
#ifndef vtkWideFoVFoldWork_h
#define vtkWideFoVFoldWork_h

#include "vtkWideFoVSortWork.h"

#include <cmath>
#include <vector>

namespace wfv
{
namespace sorting
{
// Of a triangle, bits. Of an edge that is known the fragment stage need not guess
// (order_fragment.glsl).
enum Fold : unsigned char
{
  KnownFirst = 1,  // the edge opposite to the first corner is known, and so on
  BackAtFirst = 8, // there it lies behind one that it meets in a fold, and so on
};

// Whichever way triangles are wound; where several meet in an edge, or one alone, nothing is known.
// A functor for threads.
template <typename Real>
class FoldWork
{
public:
  // places: of points (Clusters::GetPlaces); folds: one a triangle
  FoldWork(const Scene<Real>& scene, const std::vector<unsigned int>& neighbours,
    const std::vector<unsigned int>& places, const unsigned char* kinds, unsigned char* folds)
    : In(scene)
    , Corners(scene.All.GetCorners())
    , Neighbours(neighbours)
    , Places(places)
    , Kinds(kinds)
    , Folds(folds)
  {
  }

  void operator()(vtkIdType from, vtkIdType to) const
  {
    const vtkIdType end = this->In.GetEnd(static_cast<int>(to) - 1);
    for (vtkIdType i = this->In.GetFirst(static_cast<int>(from)); i < end; i++)
    {
      this->Folds[i] = (this->Kinds[i] & Cover) ? this->FindFolds(3 * i) : 0;
    }
  }

private:
  unsigned char FindFolds(vtkIdType corner) const
  {
    const vec3 p[3] = { this->In.PlaceOf(corner), this->In.PlaceOf(corner + 1),
      this->In.PlaceOf(corner + 2) };
    int folds = 0;
    for (int j = 0; j < 3; j++)
    {
      const auto edge = static_cast<std::size_t>(corner + j);
      const unsigned int other = this->Neighbours[edge];
      if (other == Clusters::NoTriangle)
      {
        continue;
      }
      const int next = (j + 1) % 3;
      const int opposite = (j + 2) % 3;
      const vec3 beyond = this->PlaceBeyond(other, edge, static_cast<std::size_t>(corner + next));
      folds |= LookAt(p[j], p[next], p[opposite], beyond, opposite);
    }
    return static_cast<unsigned char>(folds);
  }

  // The corner of a triangle that is none of two others.
  vec3 PlaceBeyond(unsigned int triangle, std::size_t from, std::size_t to) const
  {
    const unsigned int a = this->Places[this->Corners[from]];
    const unsigned int b = this->Places[this->Corners[to]];
    std::size_t corner = 3 * static_cast<std::size_t>(triangle);
    for (const std::size_t end = corner + 2; corner < end; corner++)
    {
      const unsigned int place = this->Places[this->Corners[corner]];
      if (place != a && place != b)
      {
        break;
      }
    }
    return this->In.PlaceOf(static_cast<vtkIdType>(corner));
  }

  // An edge from p to q, what its triangle ends in and what the next one does. A fold is where both
  // lie to one side of the plane through the eye; the back is what the other one comes before.
  static int LookAt(const vec3& p, const vec3& q, const vec3& own, const vec3& other, int edge)
  {
    const int known = KnownFirst << edge;
    const vec3 seen = glm::cross(p, q - p);
    const double side = glm::dot(seen, own);
    const double beyond = glm::dot(seen, other);
    if (!(std::abs(beyond) > OneSide * glm::length(seen) * glm::length(other)))
    {
      return 0;
    }
    if ((side > 0) != (beyond > 0))
    {
      return known;
    }
    const vec3 normal = glm::cross(q - p, own - p);
    const double ahead = glm::dot(normal, p);
    const double raised = glm::dot(normal, other - p);
    if (!(std::abs(raised) > OneSide * glm::length(normal) * glm::length(other - p)))
    {
      return 0;
    }
    return known | ((raised > 0) != (ahead > 0) ? BackAtFirst << edge : 0);
  }

  // Sines under which doubles say nothing of a side.
  static constexpr double OneSide = 1e-12;

  const Scene<Real>& In;
  const wfv::Corners& Corners;
  const std::vector<unsigned int>& Neighbours;
  const std::vector<unsigned int>& Places;
  const unsigned char* Kinds;
  unsigned char* Folds;
};
}
}

#endif
