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
  return 2.5 * wfvAtanh(sin(0.4 * phi) / cos(0.4 * phi));
}

WFV_FN float wfvLatitude(float y)
{
  return 2.5 * wfvAtan2(wfvTanh(0.4 * y), 1.0);
}
