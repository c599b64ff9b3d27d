// SPDX-License-Identifier: BSD-3-Clause
// Equirectangular (plate carree): x = 2 lambda / hfov, y = 2 phi / vfov.
// Equidistant along meridians and the equator. Source: Ardouin et al. 2014, eq. (1).
// Domain: the sphere. Discontinuities: the meridian lambda = +-pi; both poles stretch to
// the top and bottom borders.

const float WFV_TOP = 0.5 * WFV_PI;

// Whether y is the latitude itself.
const bool WFV_EVEN_LATITUDES = true;

WFV_FN float wfvHeight(float phi)
{
  return phi;
}

WFV_FN vec2 wfvLatitude(float y)
{
  return wfvSinCos(y);
}
