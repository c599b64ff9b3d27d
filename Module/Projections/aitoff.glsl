// SPDX-License-Identifier: BSD-3-Clause
// Aitoff: the azimuthal equidistant map of (lambda/2, phi) with x doubled, the whole
// sphere in an ellipse. With a the angle of (lambda/2, phi) from the centre:
// x = 2 cos(phi) sin(lambda/2) a / sin(a), y = sin(phi) a / sin(a).
// Source: Snyder, Flattening the Earth (1993), p. 130.
// Raw map: x in [-pi, pi], y in [-pi/2, pi/2]. Domain: the sphere. Discontinuity: the
// meridian lambda = +-pi, which is the border of the ellipse.

WFV_FN vec2 wfvFlat(vec2 halfLambda, vec2 phi)
{
  float x = phi.x * halfLambda.y;
  float s = wfvHypot(x, phi.y);
  float k = s > 0.0 ? wfvAtan2(s, phi.x * halfLambda.x) / s : 1.0;
  return vec2(2.0 * x * k, phi.y * k);
}

WFV_FN WfvRay wfvRayOfMap(vec2 m, WfvView v)
{
  m = vec2(0.5 * m.x, m.y);
  float r = wfvHypot(m.x, m.y);
  float rim = 0.5 * WFV_PI;
  WfvRay ray;
  ray.inside = r <= rim * WFV_BORDER;
  // outside, the nearest point of the border answers
  float a = min(r, rim);
  vec2 sc = wfvSinCos(a);
  float k = r > 0.0 ? sc.x / r : 1.0;
  ray.direction = wfvDoubleLongitude(vec3(m.x * k, m.y * k, max(0.0, sc.y)));
  return ray;
}
