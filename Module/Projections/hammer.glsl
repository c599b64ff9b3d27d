// SPDX-License-Identifier: BSD-3-Clause
// Hammer: equal-area, the whole sphere in an ellipse. Lambert's azimuthal
// equal-area map of (lambda/2, phi) with x doubled. Source: Snyder, Flattening
// the Earth (1993), p. 130; Ardouin et al. 2014, section 3.2.
// Raw map: x in [-2 sqrt 2, 2 sqrt 2], y in [-sqrt 2, sqrt 2].
// Domain: the sphere. Discontinuity: the meridian lambda = +-pi, which is the border of the
// ellipse.

WFV_FN vec2 wfvFlat(vec2 halfLambda, vec2 phi)
{
  float d = sqrt(1.0 + phi.x * halfLambda.x);
  return vec2(2.0 * sqrt(2.0) * phi.x * halfLambda.y / d, sqrt(2.0) * phi.y / d);
}

WFV_FN WfvRay wfvRayOfMap(vec2 m, WfvView v)
{
  m = vec2(0.5 * m.x, m.y);
  float r = wfvHypot(m.x, m.y);
  float rim = sqrt(2.0);
  WfvRay ray;
  ray.inside = r <= rim * WFV_BORDER;
  // outside, the nearest point of the border answers
  m = r > rim ? vec2(m.x / r * rim, m.y / r * rim) : m;
  float r2 = m.x * m.x + m.y * m.y;
  float k = sqrt(1.0 - 0.25 * r2);
  ray.direction = wfvDoubleLongitude(vec3(m.x * k, m.y * k, max(0.0, 1.0 - 0.5 * r2)));
  return ray;
}
