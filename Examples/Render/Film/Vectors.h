// SPDX-License-Identifier: BSD-3-Clause
// Lengths and products of vectors, beside those of MeshBuilder.h.
#ifndef WideFoVFilmVectors_h
#define WideFoVFilmVectors_h

#include "MeshBuilder.h"

#include <cmath>

namespace widefov
{
inline double Norm(const Vector3& v)
{
  return std::hypot(v[0], v[1], v[2]);
}

inline double Dot(const Vector3& a, const Vector3& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
}

#endif
