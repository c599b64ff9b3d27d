// SPDX-License-Identifier: BSD-3-Clause
// The hull of two spheres, by the ray of the pixel. It is all the spheres between them: the
// one whose surface the ray meets first is found in closed form, and then met as a sphere.
// With v from 0 to 1 along the axis, the ray passes the centre of sphere v at the distance
// hypot(D, m (v - v0)), v0 where it is nearest to the axis, and its radius is linear in v.

vec4 wfvSphereAlong(float v)
{
  return mix(wfvSphereSeen, wfvOtherSeen, v);
}

WfvCrossing wfvNothing()
{
  WfvCrossing x;
  x.met = false;
  x.distance = vec2(0.0);
  x.along = vec2(0.0);
  x.entry = vec3(0.0);
  x.exit = vec3(0.0);
  return x;
}

// Adds the sphere at v to what the line has crossed so far.
WfvCrossing wfvJoin(WfvCrossing x, vec3 u, float v)
{
  vec4 sphere = wfvSphereAlong(v);
  WfvCrossing y = wfvMeetSphere(u, sphere.xyz, sphere.w);
  bool nearer = y.met && (!x.met || y.distance.x < x.distance.x);
  bool farther = y.met && (!x.met || y.distance.y > x.distance.y);
  x.distance = vec2(nearer ? y.distance.x : x.distance.x, farther ? y.distance.y : x.distance.y);
  x.along = vec2(nearer ? v : x.along.x, farther ? v : x.along.y);
  x.entry = nearer ? y.entry : x.entry;
  x.exit = farther ? y.exit : x.exit;
  x.met = x.met || y.met;
  return x;
}

// Met where the spheres' own crossings are least and greatest. Covered where the deepest
// sphere is: those two may be missed by rounding where the ray only grazes them.
WfvCrossing wfvMeetBetween(vec3 u, float first, float last, float deepest)
{
  vec4 sphere = wfvSphereAlong(first);
  WfvCrossing x = wfvMeetSphere(u, sphere.xyz, sphere.w);
  sphere = wfvSphereAlong(last);
  WfvCrossing y = wfvMeetSphere(u, sphere.xyz, sphere.w);
  sphere = wfvSphereAlong(deepest);
  x.met = x.met || y.met || length(cross(sphere.xyz, u)) <= sphere.w;
  x.distance.y = y.distance.y;
  x.exit = y.exit;
  x.along = vec2(first, last);
  return x;
}

// e: from the first centre to the second; dr: the difference of the radii.
WfvCrossing wfvMeetHull(vec3 u, vec3 e, float dr)
{
  vec3 w0 = cross(wfvSphereSeen.xyz, u);
  vec3 w1 = cross(e, u);
  float m2 = dot(w1, w1);
  float n2 = m2 - dr * dr;
  float m = sqrt(m2);
  float v0 = -dot(w0, w1) / m2;
  float d = abs(dot(cross(w0, w1), u)) / m;
  float r = wfvSphereSeen.w + dr * v0;
  float top = r * m / sqrt(abs(n2));
  float room = n2 > 0.0 ? (top - d) * (top + d) : -(top * top + d * d);
  float stride = dot(e, u) * sqrt(max(room / (n2 * (dot(e, e) - dr * dr)), 0.0));
  float middle = v0 + r * dr / n2;
  if (n2 > 0.0)
  {
    float deepest = v0 + d * dr / (m * sqrt(n2));
    return wfvMeetBetween(u, clamp(middle - stride, 0.0, 1.0), clamp(middle + stride, 0.0, 1.0),
      clamp(deepest, 0.0, 1.0));
  }
  // looking along the tube: its side once at the most, and its ends
  WfvCrossing x = wfvJoin(wfvNothing(), u, clamp(middle + stride, 0.0, 1.0));
  return wfvJoin(wfvJoin(x, u, 0.0), u, 1.0);
}

WfvCrossing wfvMeet(vec3 u)
{
  vec3 e = wfvOtherSeen.xyz - wfvSphereSeen.xyz;
  vec3 across = cross(e, u);
  float dr = wfvOtherSeen.w - wfvSphereSeen.w;
  if (dot(e, e) > dr * dr && dot(across, across) > 0.0 && dot(across, across) != dr * dr)
  {
    return wfvMeetHull(u, e, dr);
  }
  return wfvJoin(wfvJoin(wfvNothing(), u, 0.0), u, 1.0);
}
