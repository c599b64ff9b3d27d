// SPDX-License-Identifier: BSD-3-Clause
// Fragment side of a triangle drawn with chords: what is shown is where the pixel's ray meets the
// triangle, as everywhere else. A chord decides which pixels it covers, not what is
// seen there: interpolated along it, surfaces close behind one another would change places.

void wfvMeetSurface()
{
  WfvRay ray = wfvRayAt(vec2(0.0));
  vec3 e = wfvEdgesAt(ray.direction);
  float facing = wfvPlane.w > 0.0 ? 1.0 : -1.0;
  float sum = facing * dot(ray.direction, wfvPlane.xyz);
  // between an edge and its chord the ray misses: the interpolated place stays
  if (ray.inside && sum > 0.0 && all(greaterThanEqual(e, vec3(0.0))))
  {
    wfvB = wfvWeigh(e);
    wfvSetDistance(facing * wfvPlane.w / sum);
  }
}
