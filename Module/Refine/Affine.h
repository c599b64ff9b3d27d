// SPDX-License-Identifier: BSD-3-Clause
// From the coordinates of a mesh, or of a copy of one, to those that the classifier asks for.
#ifndef WideFoVAffine_h
#define WideFoVAffine_h

#include "Projections/ProjectionMath.h"

#include <algorithm>
#include <cmath>

namespace wfv
{
// A row-major affine matrix.
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

  // By how much it stretches at the most: exact where all axes are scaled alike.
  double GetScale() const
  {
    double most = 0;
    for (const vec3& a : this->Columns)
    {
      double sum = 0;
      for (const vec3& b : this->Columns)
      {
        sum += std::abs(glm::dot(a, b));
      }
      most = std::max(most, sum);
    }
    return std::sqrt(most);
  }
};
}

#endif
