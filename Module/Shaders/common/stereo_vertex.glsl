// SPDX-License-Identifier: BSD-3-Clause
// What is drawn vertex by vertex (lines, points, spheres): each vertex where the eye sees it, as
// if it were seen from the origin of view coordinates. Exact for points; the line between two
// vertices is then that of their places. What no ray of the eye meets goes to the origin, which
// has no place in the map.
vec4 wfvSeenVertex(vec4 p)
{
  WfvRayHit s = wfvSee(wfvTilt(p.xyz, wfvView), wfvView);
  return vec4(s.seen ? wfvUntilt(s.direction * s.distance, wfvView) : vec3(0.0), p.w);
}
