// SPDX-License-Identifier: BSD-3-Clause
// Hammer: equal-area, the whole sphere in an ellipse. Lambert's azimuthal
// equal-area map of (lambda/2, phi) with x doubled. Source: Snyder, Flattening
// the Earth (1993), p. 130; Ardouin et al. 2014, section 3.2.
// Raw map: x in [-2 sqrt 2, 2 sqrt 2], y in [-sqrt 2, sqrt 2].
// Discontinuity: the meridian lambda = +-pi, which is the border of the ellipse.

// Raw map of half the longitude as (cos, sin) and the latitude as (cos, sin).
WFV_FN vec2 wfvHammer(vec2 halfLambda, vec2 phi)
{
  float d = sqrt(1.0 + phi.x * halfLambda.x);
  return vec2(2.0 * sqrt(2.0) * phi.x * halfLambda.y / d, sqrt(2.0) * phi.y / d);
}

WFV_FN vec2 wfvMap(vec2 angles, WfvView v)
{
  float half_ = 0.5 * angles.x;
  vec2 m = wfvHammer(vec2(cos(half_), sin(half_)), vec2(cos(angles.y), sin(angles.y)));
  return vec2(m.x * v.scale.x, m.y * v.scale.y);
}

// Half angles come from the direction itself, without trigonometry, and without
// cancellation on either side of the eye.
WFV_FN vec2 wfvProject(vec3 p, WfvView v)
{
  float h = wfvHypot(p.x, p.z);
  float rho = wfvHypot(h, p.y);
  vec2 halfLambda = vec2(1.0, 0.0);
  if (h > 0.0)
  {
    float major = sqrt(0.5 + 0.5 * abs(p.z) / h);
    float minor = 0.5 * abs(p.x) / h / major;
    float c = p.z < 0.0 ? major : minor;
    float s = p.z < 0.0 ? minor : major;
    halfLambda = vec2(c, p.x < 0.0 ? -s : s);
  }
  vec2 phi = rho > 0.0 ? vec2(h / rho, p.y / rho) : vec2(1.0, 0.0);
  vec2 m = wfvHammer(halfLambda, phi);
  return vec2(m.x * v.scale.x, m.y * v.scale.y);
}

WFV_FN WfvRay wfvUnproject(vec2 ndc, WfvView v)
{
  vec2 m = wfvFinite(ndc);
  m = vec2(0.5 * m.x / v.scale.x, m.y / v.scale.y);
  float r = wfvHypot(m.x, m.y);
  float rim = sqrt(2.0);
  WfvRay ray;
  ray.inside = r <= rim * WFV_BORDER;
  // outside, the nearest point of the border answers
  m = r > rim ? vec2(m.x / r * rim, m.y / r * rim) : m;
  float r2 = m.x * m.x + m.y * m.y;
  float k = sqrt(1.0 - 0.25 * r2);
  float x = m.x * k;
  float y = m.y * k;
  float z = max(0.0, 1.0 - 0.5 * r2);
  float c = wfvHypot(x, z);
  ray.direction = vec3(0.0, y < 0.0 ? -1.0 : 1.0, 0.0);
  if (c > 0.0)
  {
    ray.direction = vec3(2.0 * x * z / c, y, (x * x - z * z) / c);
  }
  return ray;
}

// x grows with lambda and, in size, towards the equator; y grows with phi and, in
// size, with |lambda|.
WFV_FN vec4 wfvBounds(vec4 a, WfvView v)
{
  float nearEquator = a.y > 0.0 ? a.y : (a.w < 0.0 ? a.w : 0.0);
  float farEquator = abs(a.y) > abs(a.w) ? a.y : a.w;
  float nearCentre = a.x > 0.0 ? a.x : (a.z < 0.0 ? a.z : 0.0);
  float farCentre = abs(a.x) > abs(a.z) ? a.x : a.z;
  return vec4(wfvMap(vec2(a.x, a.x < 0.0 ? nearEquator : farEquator), v).x,
    wfvMap(vec2(a.y < 0.0 ? farCentre : nearCentre, a.y), v).y,
    wfvMap(vec2(a.z, a.z > 0.0 ? nearEquator : farEquator), v).x,
    wfvMap(vec2(a.w > 0.0 ? farCentre : nearCentre, a.w), v).y);
}
