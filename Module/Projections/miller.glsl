// SPDX-License-Identifier: BSD-3-Clause
// Miller cylindrical: x = lambda, y = 5/4 asinh(tan(4/5 phi)), which is
// 5/2 atanh(tan(2/5 phi)): Mercator's height of four fifths of the latitude, so that
// the poles have a place. Source: Snyder, Map Projections: A Working Manual (1987),
// chapter 11. Domain: the sphere. Discontinuities: the meridian lambda = +-pi; both poles
// stretch to the top and bottom borders.

// 5/2 atanh(tan(pi/5))
const float WFV_TOP = 2.3034125433763912;

// Whether y is the latitude itself.
const bool WFV_EVEN_LATITUDES = false;

WFV_FN float wfvHeight(float phi)
{
  vec2 sc = wfvSinCos(0.4 * phi);
  return 2.5 * wfvAtanh(sc.x / sc.y);
}

// The angle from the equator is 2.5 atan(tanh(0.4 |y|)), that from the pole 2.5 atan(exp(-0.8 |y|)) less
// an eighth of a half turn: by the smaller of the two arcs, and so what that is rounded by.
WFV_FN vec2 wfvLatitude(float y)
{
  vec2 e = wfvExpOfMinus(0.8 * abs(y));
  bool low = e.x > 0.41421356;
  float a = 2.5 * (low ? wfvAtan2(e.y, 1.0 + e.x) : wfvAtan2(e.x, 1.0));
  vec2 sc = wfvSinCos(low ? a : a - 0.125 * WFV_PI);
  float s = low ? sc.x : sc.y;
  return vec2(y < 0.0 ? -s : s, low ? sc.y : sc.x);
}
