// SPDX-License-Identifier: BSD-3-Clause
// Equirectangular (plate carree): x = 2 lambda / hfov, y = 2 phi / vfov.
// Equidistant along meridians and the equator. Source: Ardouin et al. 2014, eq. (1).
// Discontinuities: the meridian lambda = +-pi; both poles stretch to the top and
// bottom borders.

// Map of (lambda, phi) in radians.
WFV_FN vec2 wfvMap(vec2 angles, WfvView v)
{
  return vec2(angles.x * v.scale.x, angles.y * v.scale.y);
}

WFV_FN vec2 wfvProject(vec3 p, WfvView v)
{
  return wfvMap(wfvMeridianAngles(p), v);
}

WFV_FN WfvRay wfvUnproject(vec2 ndc, WfvView v)
{
  vec2 m = wfvFinite(ndc);
  vec2 angles = vec2(m.x / v.scale.x, m.y / v.scale.y);
  WfvRay ray;
  ray.inside = abs(angles.x) <= WFV_PI * WFV_BORDER && abs(angles.y) <= 0.5 * WFV_PI * WFV_BORDER;
  ray.direction = wfvMeridianDirection(vec2(max(-WFV_PI, min(WFV_PI, angles.x)),
    max(-0.5 * WFV_PI, min(0.5 * WFV_PI, angles.y))));
  return ray;
}

// NDC rectangle (x min, y min, x max, y max) of a rectangle of angles (the same order).
WFV_FN vec4 wfvBounds(vec4 a, WfvView v)
{
  vec2 low = wfvMap(vec2(a.x, a.y), v);
  vec2 high = wfvMap(vec2(a.z, a.w), v);
  return vec4(low.x, low.y, high.x, high.y);
}
