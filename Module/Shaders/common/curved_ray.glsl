// SPDX-License-Identifier: BSD-3-Clause
// What a pixel sees at a depth, of an eye whose rays are lines of the cube of the map with its depth.

// The ray of the map, for a place of the picture and a depth; outside where the cube ends.
WfvRay wfvRayOfDepth(vec2 place, float depth)
{
  vec2 ndc = wfvUnshift(place, depth, wfvView);
  WfvRay ray = wfvUnproject(ndc, wfvView);
  ray.inside = ray.inside && abs(ndc.x) <= 1.0 && abs(ndc.y) <= 1.0;
  return ray;
}
