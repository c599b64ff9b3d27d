// SPDX-License-Identifier: BSD-3-Clause
// A cylinder with flat ends, by the ray of the pixel: a circle in the plane across the
// axis, cut by the slab between the ends.

WfvCrossing wfvMeet(vec3 u)
{
  vec3 c = wfvSphereSeen.xyz;
  vec3 axis = wfvOtherSeen.xyz;
  float half_ = wfvOtherSeen.w;
  vec3 across = cross(axis, cross(u, axis));
  float m = length(across);
  vec3 c2 = cross(axis, cross(c, axis));
  WfvCrossing x = wfvMeetSphere(m > 0.0 ? across / m : vec3(0.0), c2, wfvSphereSeen.w);
  float height = dot(c, axis);
  float speed = dot(u, axis);
  if (m > 0.0)
  {
    x.distance /= m;
  }
  else
  {
    // along the axis: inside the circle or not, all the way
    x.met = length(c2) <= wfvSphereSeen.w;
    x.distance = vec2(-1e30, 1e30);
  }
  vec2 ends = vec2(height - half_, height + half_) / speed;
  ends = speed < 0.0 ? vec2(ends.y, ends.x) : ends;
  if (speed == 0.0)
  {
    ends = abs(height) <= half_ ? vec2(-1e30, 1e30) : vec2(1e30, -1e30);
  }
  vec3 first = speed < 0.0 ? axis : -axis;
  x.entry = ends.x > x.distance.x ? first : x.entry;
  x.exit = ends.y < x.distance.y ? -first : x.exit;
  x.distance = vec2(max(x.distance.x, ends.x), min(x.distance.y, ends.y));
  x.met = x.met && x.distance.x <= x.distance.y;
  x.along = clamp(0.5 + 0.5 * (x.distance * speed - height) / half_, 0.0, 1.0);
  return x;
}
