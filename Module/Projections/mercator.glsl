// SPDX-License-Identifier: BSD-3-Clause
// Mercator: x = lambda, y = asinh(tan(phi)), which is 2 atanh(tan(phi/2)). Conformal.
// Source: Snyder, Map Projections: A Working Manual (1987), chapter 7.
// Domain: latitudes up to atan(sinh(pi)), 85.0511 degrees, where y = pi and the map of the
// whole circle is a square, as web maps cut it: the poles are infinitely far away.
// Discontinuity: the meridian lambda = +-pi.

const float WFV_TOP = WFV_PI;
const float WFV_MOST_HEIGHT = 170.1022575596132; // degrees: twice atan(sinh(pi))

// Whether y is the latitude itself.
const bool WFV_EVEN_LATITUDES = false;

// tan(phi/2) at which the height ends, for what lies beyond the domain.
const float WFV_MERCATOR_END = 0.999999;

WFV_FN float wfvHeight(float phi)
{
  vec2 sc = wfvSinCos(0.5 * phi);
  float t = sc.x / sc.y;
  return 2.0 * wfvAtanh(max(-WFV_MERCATOR_END, min(WFV_MERCATOR_END, t)));
}

// tanh(y) and 1 / cosh(y), by what shrinks towards the poles: so does what it is rounded by.
WFV_FN vec2 wfvLatitude(float y)
{
  vec2 e = wfvExpOfMinus(abs(y));
  float s = e.y * (1.0 + e.x);
  return vec2(y < 0.0 ? -s : s, 2.0 * e.x) / (1.0 + e.x * e.x);
}
