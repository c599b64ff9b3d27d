// SPDX-License-Identifier: BSD-3-Clause
// What an eye sees: shared by the stereo models (Stereo/*.glsl).

// What an eye sees of a point.
struct WfvRayHit
{
  vec3 direction; // unit length; 0 where the point is the eye itself
  float distance; // along the ray, in the unit of the point
  bool seen;      // some ray of this eye meets the point
};

// How far the eye is from the middle.
WFV_FN float wfvFromMiddle(WfvView v)
{
  return v.eye == WFV_EYE_MIDDLE ? 0.0 : v.halfEyes;
}

// How far it is to the right of the middle.
WFV_FN float wfvToRight(WfvView v)
{
  return v.eye == WFV_EYE_LEFT ? -v.halfEyes : wfvFromMiddle(v);
}

// The vertical in tilted view coordinates.
WFV_FN vec3 wfvUpright(WfvView v)
{
  return WFV_TILTED ? vec3(0.0, v.tilt.x, -v.tilt.y) : vec3(0.0, 1.0, 0.0);
}

// From one place, whatever the direction.
WFV_FN WfvRayHit wfvRayHitFrom(vec3 p, vec3 eye)
{
  vec3 d = p - eye;
  WfvRayHit s;
  s.distance = wfvHypot(wfvHypot(d.x, d.y), d.z);
  s.seen = s.distance > 0.0;
  s.direction = s.seen ? d / s.distance : vec3(0.0, 0.0, 0.0);
  return s;
}
