// SPDX-License-Identifier: BSD-3-Clause
// A splat, by the ray of the pixel: a disc about the point, across the line from the eye
// to it. Stock VTK draws a triangle round that disc; beyond the disc a gaussian has less
// than a hundredth of its height, and there is no triangle that looks the same everywhere.

uniform float WFV_SPLAT_SCALE; // radius of the disc in units of the gaussian's, set by the mapper

WfvCrossing wfvMeet(vec3 u)
{
  float d = length(wfvSphere.xyz);
  vec3 ahead = wfvSphere.xyz / d;
  float c = dot(u, ahead);
  WfvCrossing x;
  // from a cross product, so that nothing cancels far away
#if WFV_NON_CENTRAL_IMPOSTORS
  // both eyes see the same disc
  float t = dot(wfvSphereSeen.xyz, ahead) / c;
  x.met = c > 0.0 && length(cross(ahead, cross(u, wfvSphereSeen.xyz))) <= c * wfvSphere.w;
#else
  float t = d / c;
  x.met = c > 0.0 && t * length(cross(u, ahead)) <= wfvSphere.w;
#endif
  x.distance = vec2(t);
  x.along = vec2(0.0);
  x.entry = -ahead;
  x.exit = -ahead;
  return x;
}

// Place on the disc in units of the gaussian's radius: x to the right, y upwards, with
// the view's own up, or its right where that is behind or ahead.
vec2 wfvSplatOffset()
{
  vec3 centre = wfvUntilt(wfvSphere.xyz, wfvView);
  vec3 ahead = centre / length(centre);
  vec3 right = cross(ahead, vec3(0.0, 1.0, 0.0));
  right = dot(right, right) > 1e-12 ? normalize(right) : vec3(1.0, 0.0, 0.0);
  vec3 from = wfvSurface / wfvScale() - centre;
  return vec2(dot(from, right), dot(from, cross(right, ahead))) * (WFV_SPLAT_SCALE / wfvSphere.w);
}
