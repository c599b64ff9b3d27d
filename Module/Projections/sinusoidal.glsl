// SPDX-License-Identifier: BSD-3-Clause
// Sinusoidal (Sanson-Flamsteed): x = lambda cos(phi), y = phi. Equal-area; true to scale
// along every parallel. Source: Snyder, Map Projections: A Working Manual (1987), chapter
// 30. Domain: the sphere. Discontinuity: the meridian lambda = +-pi, the curved border;
// the poles are points, in which the border has corners.

const float WFV_TOP = 0.5 * WFV_PI;

WFV_FN vec2 wfvParallel(vec2 phi, float latitude)
{
  return vec2(phi.x, latitude);
}

WFV_FN vec3 wfvAtHeight(float y)
{
  vec2 phi = wfvSinCos(y);
  float c = max(0.0, phi.y);
  return vec3(c, c, phi.x);
}
