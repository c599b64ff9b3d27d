// SPDX-License-Identifier: BSD-3-Clause
// Shared by every projection, and included last: the ray of a point of the picture. Each
// brings
//   WfvRay wfvRayOfMap(vec2 m, WfvView v)  the ray of a point of its raw map: that of the
//       nearest point of the map, and outside, where there is none here

WFV_FN WfvRay wfvUnproject(vec2 ndc, WfvView v)
{
  vec2 m = wfvFinite(ndc);
  WfvRay ray = wfvRayOfMap(vec2(m.x / v.scale.x, m.y / v.scale.y), v);
  ray.inside = ray.inside && abs(m.x) < WFV_FAR_NDC && abs(m.y) < WFV_FAR_NDC;
  return ray;
}
