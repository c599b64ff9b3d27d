// SPDX-License-Identifier: BSD-3-Clause
// Moves a vertex to where the eye sees it, as if it were seen from the origin of view coordinates.
// The line between two vertices is then the line between the places where they are seen. A point
// that no ray of the eye meets goes to the origin, which has no place in the map. A corner of a
// piece (WFV_PIECES) is seen, though rounding may say otherwise beside the circle of the eyes.
vec4 wfvSeenVertex(vec4 p)
{
  WfvRayHit s = wfvSee(wfvTilt(p.xyz, wfvView), wfvView);
  bool seen = s.seen || WFV_PIECES == 1;
  return vec4(seen ? wfvUntilt(s.direction * s.distance, wfvView) : vec3(0.0), p.w);
}
