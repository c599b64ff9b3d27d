// SPDX-License-Identifier: BSD-3-Clause
// Vectors of rational numbers, in which every decision about a ray and a triangle is exact.
#ifndef WideFoVRational_h
#define WideFoVRational_h

#include "Projections/ProjectionMath.h"

#include <boost/multiprecision/cpp_int.hpp>

#include <array>

namespace wfv
{
namespace reference
{
using Rational = boost::multiprecision::cpp_rational;
using RationalVector = std::array<Rational, 3>;

inline RationalVector Exact(const vec3& v)
{
  return { { Rational(v.x), Rational(v.y), Rational(v.z) } };
}

inline RationalVector Minus(const RationalVector& a, const RationalVector& b)
{
  return { { a[0] - b[0], a[1] - b[1], a[2] - b[2] } };
}

inline RationalVector Cross(const RationalVector& a, const RationalVector& b)
{
  return { { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] } };
}

inline Rational Dot(const RationalVector& a, const RationalVector& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
}
}

#endif
