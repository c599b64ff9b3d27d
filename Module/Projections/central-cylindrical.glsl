// SPDX-License-Identifier: BSD-3-Clause
// Central cylindrical: x = lambda, y = tan(phi), the perspective picture on a cylinder
// round the eye, as a rotating slit camera takes it. Source: Snyder, Flattening the Earth
// (1993), p. 106. Domain: latitudes up to 75 degrees, where y is 2 + sqrt(3): the poles are
// infinitely far away. Discontinuity: the meridian lambda = +-pi.

const float WFV_TOP = 3.7320508075688773;
const float WFV_MOST_HEIGHT = 150.0; // degrees

// Whether y is the latitude itself.
const bool WFV_EVEN_LATITUDES = false;

// Cosine of the latitude at which the height ends, for what lies beyond the domain.
const float WFV_CENTRAL_END = 1e-6;

WFV_FN float wfvHeight(float phi)
{
  vec2 at = wfvSinCos(phi); // not GLSL's own, see arc_minus_sine.glsl
  return at.x / max(at.y, WFV_CENTRAL_END);
}

WFV_FN vec2 wfvLatitude(float y)
{
  return vec2(y, 1.0) / sqrt(1.0 + y * y);
}
