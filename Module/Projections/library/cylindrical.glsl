// SPDX-License-Identifier: BSD-3-Clause
// Shared by the cylindrical maps: x is the longitude, y a function of the latitude.
// Included after the projection, which brings
//   float wfvHeight(float phi)   y in the raw map, growing and odd
//   vec2 wfvLatitude(float y)    sine and cosine of the latitude there, y in [-WFV_TOP, WFV_TOP]
//   WFV_EVEN_LATITUDES           whether y is the latitude itself
//   WFV_TOP                      y at the largest latitude of the domain
// Discontinuities: the meridian lambda = +-pi, a straight line; each pole is stretched
// to a line, or lies infinitely far away.

// Map of (lambda, phi) in radians.
WFV_FN vec2 wfvMap(vec2 angles, WfvView v)
{
  return vec2(angles.x * v.scale.x, wfvHeight(angles.y) * v.scale.y);
}

WFV_FN vec2 wfvProject(vec3 p, WfvView v)
{
  return wfvMap(wfvMeridianAngles(p), v);
}

WFV_FN WfvRay wfvRayOfMap(vec2 m, WfvView v)
{
  WfvRay ray;
  ray.inside = abs(m.x) <= WFV_PI * WFV_BORDER && abs(m.y) <= WFV_TOP * WFV_BORDER;
  ray.direction = wfvMeridianDirectionOf(wfvSinCos(max(-WFV_PI, min(WFV_PI, m.x))),
    wfvLatitude(max(-WFV_TOP, min(WFV_TOP, m.y))));
  return ray;
}
