// SPDX-License-Identifier: BSD-3-Clause
// Cylindrical equal-area (Lambert): x = lambda, y = sin(phi). Source: Snyder, Map
// Projections: A Working Manual (1987), chapter 10, standard parallel at the equator.
// Domain: the sphere. Discontinuities: the meridian lambda = +-pi; both poles stretch to
// the top and bottom borders, where the map is flat: y hardly tells latitudes apart.

const float WFV_TOP = 1.0;

// Whether y is the latitude itself.
const bool WFV_EVEN_LATITUDES = false;

WFV_FN float wfvHeight(float phi)
{
  return wfvSinCos(phi).x;
}

WFV_FN vec2 wfvLatitude(float y)
{
  return wfvSinCos(wfvAtan2(y, sqrt((1.0 - y) * (1.0 + y))));
}
