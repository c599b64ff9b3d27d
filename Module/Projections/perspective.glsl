// SPDX-License-Identifier: BSD-3-Clause
// Perspective (gnomonic): straight lines stay straight; fields of view below 180
// degrees. The paper's baseline. Nothing behind the eye has a place in the map.

// Raw map of (lambda, phi) in radians, |lambda| < pi/2.
WFV_FN vec2 wfvMap(vec2 angles, WfvView v)
{
  vec2 lambda = wfvSinCos(angles.x);
  vec2 phi = wfvSinCos(angles.y);
  return vec2(lambda.x / lambda.y * v.scale.x, phi.x / (phi.y * lambda.y) * v.scale.y);
}

WFV_FN vec2 wfvProject(vec3 p, WfvView v)
{
  float w = max(-p.z, 1e-30);
  return vec2(p.x / w * v.scale.x, p.y / w * v.scale.y);
}

WFV_FN WfvRay wfvRayOfMap(vec2 m, WfvView v)
{
  vec3 d = vec3(m.x, m.y, -1.0);
  WfvRay ray;
  ray.inside = true;
  ray.direction = d / wfvHypot(wfvHypot(d.x, d.y), 1.0);
  return ray;
}

// NDC rectangle of a rectangle of (lambda, phi): the window where the angles come near
// a right angle. y grows with phi and, in size, with |lambda|.
WFV_FN vec4 wfvBounds(vec4 a, WfvView v)
{
  float far = max(max(abs(a.x), abs(a.z)), max(abs(a.y), abs(a.w)));
  if (far > 0.499 * WFV_PI)
  {
    return vec4(-1.0, -1.0, 1.0, 1.0);
  }
  float nearCentre = a.x > 0.0 ? a.x : (a.z < 0.0 ? a.z : 0.0);
  float farCentre = abs(a.x) > abs(a.z) ? a.x : a.z;
  vec2 low = wfvMap(vec2(a.y < 0.0 ? farCentre : nearCentre, a.y), v);
  vec2 high = wfvMap(vec2(a.w > 0.0 ? farCentre : nearCentre, a.w), v);
  return vec4(wfvMap(vec2(a.x, 0.0), v).x, low.y, wfvMap(vec2(a.z, 0.0), v).x, high.y);
}
