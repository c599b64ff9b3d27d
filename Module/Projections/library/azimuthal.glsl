// SPDX-License-Identifier: BSD-3-Clause
// Shared by the round maps: the azimuth is kept, the radius is a function of the angle
// theta from -z. Included after the projection, which brings
//   float wfvRadius(float theta, WfvView v)  radius in the raw map, 0 on the axis; grows on
//       all of [0, pi], also beyond the domain, so that what lies there stays outside
//   float wfvTheta(float r, WfvView v)       its inverse on the domain, [0, v.maxAngle]
//   float wfvThetaAt(vec2 m, float r, WfvView v)  the same from the point m of the radius r

// Map of (azimuth, theta) in radians.
WFV_FN vec2 wfvMap(vec2 angles, WfvView v)
{
  float r = wfvRadius(angles.y, v);
  vec2 sc = wfvSinCos(angles.x);
  return vec2(r * sc.y * v.scale.x, r * sc.x * v.scale.y);
}

WFV_FN vec2 wfvProject(vec3 p, WfvView v)
{
  float len = wfvHypot(p.x, p.y);
  float r = wfvRadius(wfvAtan2(len, -p.z), v);
  // straight behind the eye every azimuth is right: +x is taken
  vec2 d = len > 0.0 ? vec2(p.x / len, p.y / len) : vec2(1.0, 0.0);
  return vec2(r * d.x * v.scale.x, r * d.y * v.scale.y);
}

WFV_FN WfvRay wfvRayOfMap(vec2 m, WfvView v)
{
  float r = wfvHypot(m.x, m.y);
  WfvRay ray;
  ray.inside = r <= wfvRadius(v.maxAngle, v) * WFV_BORDER;
  float theta = min(wfvThetaAt(m, r, v), v.maxAngle);
  vec2 sc = wfvSinCos(theta);
  float s = max(sc.x, WFV_AT_SINGULARITY);
  vec2 d = r > 0.0 ? vec2(m.x / r, m.y / r) : vec2(1.0, 0.0);
  ray.direction = vec3(s * d.x, s * d.y, -sc.y);
  return ray;
}

// NDC rectangle of a ring sector (azimuth min, theta min, azimuth max, theta max).
WFV_FN vec4 wfvBounds(vec4 a, WfvView v)
{
  float inner = wfvRadius(a.y, v);
  float outer = wfvRadius(a.w, v);
  vec4 b = vec4(outer, outer, -outer, -outer);
  for (int i = 0; i < 2; i++)
  {
    vec2 sc = wfvSinCos(i == 0 ? a.x : a.z);
    b = vec4(min(b.x, sc.y * (sc.y < 0.0 ? outer : inner)), min(b.y, sc.x * (sc.x < 0.0 ? outer : inner)),
      max(b.z, sc.y * (sc.y > 0.0 ? outer : inner)), max(b.w, sc.x * (sc.x > 0.0 ? outer : inner)));
  }
  // the four axes of the circle, wherever the sector reaches them
  float quarter = 0.5 * WFV_PI;
  for (float k = ceil(a.x / quarter); k * quarter <= a.z; k += 1.0)
  {
    vec2 sc = wfvSinCos(k * quarter);
    vec2 p = vec2(outer * sc.y, outer * sc.x);
    b = vec4(min(b.x, p.x), min(b.y, p.y), max(b.z, p.x), max(b.w, p.y));
  }
  return vec4(b.x * v.scale.x, b.y * v.scale.y, b.z * v.scale.x, b.w * v.scale.y);
}
