// SPDX-License-Identifier: BSD-3-Clause
// Azimuthal equidistant (fisheye, dome): the distance from the centre is the angle
// theta from -z, r = theta / (fov/2), or the lens polynomial
// r = c1 theta + c2 theta^2 + .. + c5 theta^5. Source: Bailey, Clothier and Gebbie
// 2006, section 3. Discontinuity: the antipode +z, which becomes the outer circle.

// Radius in the raw map of the angle theta in radians; the ideal lens has r = theta.
WFV_FN float wfvRadius(float theta, WfvView v)
{
  float r = theta * (v.lens.x + theta * (v.lens.y + theta * (v.lens.z + theta * (v.lens.w + theta * v.lens5))));
  return v.lens.x == 0.0 ? theta : r;
}

WFV_FN float wfvRadiusSlope(float t, WfvView v)
{
  float s = v.lens.x + t * (2.0 * v.lens.y + t * (3.0 * v.lens.z + t * (4.0 * v.lens.w + t * 5.0 * v.lens5)));
  return v.lens.x == 0.0 ? 1.0 : s;
}

// The inverse of wfvRadius on [0, maxAngle]: Newton, kept inside a bracket. The lens
// is monotone there (checked when it is set). The first guess is exact at both ends:
// beside them a step from elsewhere leaves the bracket, and is halved time and again.
WFV_FN float wfvTheta(float r, WfvView v)
{
  if (v.lens.x == 0.0)
  {
    return r;
  }
  float low = 0.0;
  float high = v.maxAngle;
  float t = high * min(1.0, r / wfvRadius(high, v));
  for (int i = 0; i < WFV_NEWTON_STEPS; i++)
  {
    float e = wfvRadius(t, v) - r;
    if (e > 0.0)
    {
      high = t;
    }
    else
    {
      low = t;
    }
    float slope = wfvRadiusSlope(t, v);
    float next = slope > 0.0 ? t - e / slope : 0.5 * (low + high);
    t = next >= low && next <= high ? next : 0.5 * (low + high);
  }
  return t;
}

// Map of (azimuth, theta) in radians.
WFV_FN vec2 wfvMap(vec2 angles, WfvView v)
{
  float r = wfvRadius(angles.y, v);
  return vec2(r * cos(angles.x) * v.scale.x, r * sin(angles.x) * v.scale.y);
}

WFV_FN vec2 wfvProject(vec3 p, WfvView v)
{
  float len = wfvHypot(p.x, p.y);
  float r = wfvRadius(wfvAtan2(len, -p.z), v);
  // straight behind the eye every azimuth is right: +x is taken
  vec2 d = len > 0.0 ? vec2(p.x / len, p.y / len) : vec2(1.0, 0.0);
  return vec2(r * d.x * v.scale.x, r * d.y * v.scale.y);
}

WFV_FN WfvRay wfvUnproject(vec2 ndc, WfvView v)
{
  vec2 m = wfvFinite(ndc);
  m = vec2(m.x / v.scale.x, m.y / v.scale.y);
  float r = wfvHypot(m.x, m.y);
  WfvRay ray;
  ray.inside = r <= wfvRadius(v.maxAngle, v) * WFV_BORDER;
  float theta = min(wfvTheta(r, v), v.maxAngle);
  float s = sin(theta);
  vec2 d = r > 0.0 ? vec2(m.x / r, m.y / r) : vec2(1.0, 0.0);
  ray.direction = vec3(s * d.x, s * d.y, -cos(theta));
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
    float u = i == 0 ? a.x : a.z;
    b = vec4(min(b.x, cos(u) * (cos(u) < 0.0 ? outer : inner)), min(b.y, sin(u) * (sin(u) < 0.0 ? outer : inner)),
      max(b.z, cos(u) * (cos(u) > 0.0 ? outer : inner)), max(b.w, sin(u) * (sin(u) > 0.0 ? outer : inner)));
  }
  // the four axes of the circle, wherever the sector reaches them
  float quarter = 0.5 * WFV_PI;
  for (float k = ceil(a.x / quarter); k * quarter <= a.z; k += 1.0)
  {
    vec2 p = vec2(outer * cos(k * quarter), outer * sin(k * quarter));
    b = vec4(min(b.x, p.x), min(b.y, p.y), max(b.z, p.x), max(b.w, p.y));
  }
  return vec4(b.x * v.scale.x, b.y * v.scale.y, b.z * v.scale.x, b.w * v.scale.y);
}
