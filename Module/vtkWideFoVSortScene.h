// SPDX-License-Identifier: BSD-3-Clause
// A mesh and the view that its triangles are sorted for.
#ifndef vtkWideFoVSortScene_h
#define vtkWideFoVSortScene_h

#include "vtkWideFoVClusters.h"
#include "vtkWideFoVTriangleJudge.h"

#include <algorithm>

namespace wfv
{
// An affine map, from a row-major matrix.
struct Affine
{
  vec3 Columns[3];
  vec3 Shift;

  explicit Affine(const double m[16])
    : Columns{ vec3(m[0], m[4], m[8]), vec3(m[1], m[5], m[9]), vec3(m[2], m[6], m[10]) }
    , Shift(m[3], m[7], m[11])
  {
  }

  vec3 Of(double x, double y, double z) const
  {
    return this->Columns[0] * x + this->Columns[1] * y + this->Columns[2] * z + this->Shift;
  }
};

// A mesh in the map's own frame.
template <typename Real>
struct Scene
{
  const Clusters& All;
  const Real* Points;
  Affine ToMap;
  const SortView& V;

  vec3 PlaceOf(vtkIdType corner) const
  {
    const Real* p = this->Points + 3 * static_cast<std::size_t>(this->All.GetCorners()[corner]);
    return this->ToMap.Of(p[0], p[1], p[2]);
  }

  Box BoxOf(int cluster) const
  {
    const std::array<double, 6>& b = this->All.GetBounds(cluster);
    Box box;
    for (int i = 0; i < 8; i++)
    {
      box.Add(this->ToMap.Of(b[i & 1], b[2 + ((i >> 1) & 1)], b[4 + ((i >> 2) & 1)]));
    }
    box.Grow(this->V.Reach);
    return box;
  }

  // Sine of the angle by which the ray of a sample is on the triangle's side of an edge, by the
  // edge itself, for one of the eyes; below 0 on the other. No number for an edge without length.
  double GetInside(unsigned int sample, unsigned int edge, int eye) const
  {
    const unsigned int first = edge - edge % 3;
    const vec2 ndc = this->V.Samples.NdcAt(this->V.Samples.SampleAt(sample));
    const vec3 ray = this->V.Map->Unproject(ndc, this->V.View).direction;
    const vec3 start = this->V.Own ? this->V.Own->EyeAt(ray, this->V.GetViewOf(eye)) : vec3(0);
    const vec3 normal = glm::normalize(glm::cross(
      this->PlaceOf(edge) - start, this->PlaceOf(first + (edge - first + 1) % 3) - start));
    const vec3 third = this->PlaceOf(first + (edge - first + 2) % 3) - start;
    return glm::sign(glm::dot(normal, third)) * glm::dot(normal, ray);
  }

  bool IsUnseen(int cluster) const
  {
    return wfv::IsUnseen(*this->V.Map, this->V.View, this->BoxOf(cluster), this->V.Part);
  }

  vtkIdType GetFirst(int cluster) const { return static_cast<vtkIdType>(cluster) * Clusters::Size; }
  vtkIdType GetEnd(int cluster) const
  {
    return std::min<vtkIdType>(
      this->GetFirst(cluster) + Clusters::Size, this->All.GetNumberOfTriangles());
  }
};
}

#endif
