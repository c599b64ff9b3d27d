// SPDX-License-Identifier: BSD-3-Clause
// Panini (the classical one, d = 1): the cylinder round the eye, drawn in perspective from
// its far side. x = 2 tan(lambda/2), y = tan(phi) / cos^2(lambda/2). Vertical lines and
// lines through the centre stay straight. Source: Sharpless, Postle and German, Pannini: A
// New Projection for Rendering Wide Angle Perspective Images (2010), equations for d = 1.
// Domain: longitudes up to 160 and latitudes up to 75 degrees: the meridian behind the eye
// and the poles are infinitely far away.

const float WFV_MOST_WIDTH = 320.0;  // degrees
const float WFV_MOST_HEIGHT = 150.0; // degrees
const float WFV_PANINI_SIDE = 5.6712818196177094; // tan(80 degrees), half of x
const float WFV_PANINI_TOP = 3.7320508075688773;  // tan(75 degrees)

// What the denominator may fall to, relative, for what lies beyond the domain.
const float WFV_PANINI_END = 1e-6;

WFV_FN vec2 wfvProject(vec3 p, WfvView v)
{
  float h = wfvHypot(p.x, p.z);
  float rho = wfvHypot(h, p.y);
  if (!(h > 0.0))
  {
    return vec2(0.0, p.y < 0.0 ? -v.scale.y / WFV_PANINI_END : v.scale.y / WFV_PANINI_END);
  }
  // h - z, behind the eye without cancellation
  float w = p.z < 0.0 ? h - p.z : p.x / (h + p.z) * p.x;
  float d = max(w, WFV_PANINI_END * rho);
  // at the meridian behind the eye x is still on one side, far away, not between the two
  float side = p.z < 0.0 ? abs(p.x) : max(abs(p.x), sqrt(WFV_PANINI_END * rho * (h + p.z)));
  float x = 2.0 * side / d * v.scale.x;
  return vec2(p.x < 0.0 ? -x : x, 2.0 * p.y / d * v.scale.y);
}

// Map of (lambda, phi) in radians.
WFV_FN vec2 wfvMap(vec2 angles, WfvView v)
{
  float half_ = max(-0.5 * WFV_PI, min(0.5 * WFV_PI, 0.5 * angles.x));
  vec2 lambda = wfvSinCos(half_);
  vec2 phi = wfvSinCos(angles.y);
  float c = max(lambda.y, WFV_PANINI_END);
  float d = max(c * c * phi.y, WFV_PANINI_END);
  return vec2(2.0 * lambda.x / c * v.scale.x, phi.x / d * v.scale.y);
}

WFV_FN WfvRay wfvRayOfMap(vec2 m, WfvView v)
{
  float u = 0.5 * m.x;
  float y = m.y;
  WfvRay ray;
  ray.inside = abs(u) <= WFV_PANINI_SIDE * WFV_BORDER;
  u = max(-WFV_PANINI_SIDE, min(WFV_PANINI_SIDE, u));
  float top = WFV_PANINI_TOP * (1.0 + u * u);
  ray.inside = ray.inside && abs(y) <= top * WFV_BORDER;
  y = max(-top, min(top, y));
  vec3 d = vec3(2.0 * u, y, u * u - 1.0);
  ray.direction = d / wfvHypot(1.0 + u * u, y);
  return ray;
}
