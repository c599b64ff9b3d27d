// SPDX-License-Identifier: BSD-3-Clause
// Shared by the maps that are functions of half the longitude and the latitude. Included
// after the projection, which brings
//   vec2 wfvFlat(vec2 halfLambda, vec2 phi)  the raw map of their (cosine, sine)
//   WfvRay wfvRayOfMap(vec2 m, WfvView v)

// Map of (lambda, phi) in radians.
WFV_FN vec2 wfvMap(vec2 angles, WfvView v)
{
  vec2 lambda = wfvSinCos(0.5 * angles.x);
  vec2 phi = wfvSinCos(angles.y);
  vec2 m = wfvFlat(vec2(lambda.y, lambda.x), vec2(max(0.0, phi.y), phi.x));
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
  vec2 m = wfvFlat(halfLambda, phi);
  return vec2(m.x * v.scale.x, m.y * v.scale.y);
}
