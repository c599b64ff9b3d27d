// SPDX-License-Identifier: BSD-3-Clause
// Compiles the projection files as C++: GLSL's names from GLM, float as double.
#ifndef ProjectionMath_h
#define ProjectionMath_h

#include <glm/glm.hpp>

#include <cmath>

namespace wfv
{
class DirectionMap;

using vec2 = glm::dvec2;
using vec3 = glm::dvec3;
using vec4 = glm::dvec4;

using glm::abs;
using glm::ceil;
using glm::cross;
using glm::dot;
using glm::exp;
using glm::floor;
using glm::max;
using glm::min;
using glm::sqrt;

// GLSL lacks these or leaves their accuracy open, so the shaders bring their own
// (glsl_math.glsl); in double the standard library's serve.
inline double wfvAtan2(double y, double x)
{
  return std::atan2(y, x);
}
inline double wfvHypot(double x, double y)
{
  return std::sqrt(x * x + y * y); // directions neither overflow nor vanish
}
inline vec2 wfvSinCos(double x)
{
  return vec2(std::sin(x), std::cos(x));
}
inline double wfvLog(double x)
{
  return std::log(x);
}

inline double wfvAtanh(double x)
{
  return std::atanh(x);
}
inline vec2 wfvExpOfMinus(double x)
{
  return vec2(std::exp(-x), -std::expm1(-x));
}
inline double wfvCbrt(double x)
{
  return std::cbrt(x);
}

// Newton steps of an inverse at the most (glsl_math.glsl): enough for double from any bracket.
constexpr int WFV_NEWTON_STEPS = 64;

// The step after which the next result is double's last (glsl_math.glsl).
constexpr double WFV_ROOT_STEP = 1e-8;

// Double tells the sides of a border apart (glsl_math.glsl).
constexpr double WFV_BESIDE_SEAM = 0;

#define WFV_FN inline
#define WFV_TABLES const DirectionMap*
#define WFV_DEPTH_MAPPING(v) (v).depthMapping
#define WFV_TILTED true
#define WFV_LENSED true
#define float double
#include "library/common.glsl"
#include "library/ray_hit.glsl"
#include "library/depth.glsl"
#undef float
#undef WFV_TABLES
#undef WFV_DEPTH_MAPPING
#undef WFV_TILTED
}

#endif
