// SPDX-License-Identifier: BSD-3-Clause
// Shared by the maps whose parallels are straight and evenly divided: x = lambda times
// the width of the parallel. Included after the projection, which brings
//   vec2 wfvParallel(vec2 phi, float latitude)  width and y of a parallel, from the
//       latitude's (cosine, sine) and the latitude itself; the width falls towards the poles
//   vec3 wfvAtHeight(float y)                   width, cosine and sine of the latitude
//   WFV_TOP                                     y of the north pole
// Discontinuity: the meridian lambda = +-pi, the curved border on both sides.

// Map of (lambda, phi) in radians.
WFV_FN vec2 wfvMap(vec2 angles, WfvView v)
{
  vec2 phi = wfvSinCos(angles.y);
  vec2 row = wfvParallel(vec2(max(0.0, phi.y), phi.x), angles.y);
  return vec2(angles.x * row.x * v.scale.x, row.y * v.scale.y);
}

WFV_FN vec2 wfvProject(vec3 p, WfvView v)
{
  float h = wfvHypot(p.x, p.z);
  float rho = wfvHypot(h, p.y);
  vec2 phi = rho > 0.0 ? vec2(h / rho, p.y / rho) : vec2(1.0, 0.0);
  vec2 row = wfvParallel(phi, wfvAtan2(p.y, h));
  return vec2(wfvAtan2(p.x, -p.z) * row.x * v.scale.x, row.y * v.scale.y);
}

WFV_FN WfvRay wfvRayOfMap(vec2 m, WfvView v)
{
  vec3 row = wfvAtHeight(max(-WFV_TOP, min(WFV_TOP, m.y)));
  WfvRay ray;
  ray.inside = abs(m.y) <= WFV_TOP * WFV_BORDER && abs(m.x) <= WFV_PI * row.x * WFV_BORDER;
  float lambda = row.x > 0.0 ? max(-WFV_PI, min(WFV_PI, m.x / row.x)) : 0.0;
  vec2 sc = wfvSinCos(lambda);
  ray.direction = wfvOnItsSide(vec3(row.y * sc.x, row.z, -row.y * sc.y), m.x);
  return ray;
}
