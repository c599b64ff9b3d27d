// SPDX-License-Identifier: BSD-3-Clause
// As planes_fp64.glsl, where OpenGL has no doubles.

// Without doubles from the nearer corner, or the farther one's rounding would count in full.
vec3 wfvEdgePlane(int i, int j)
{
  float a = dot(wfvP[i], wfvP[i]);
  float b = dot(wfvP[j], wfvP[j]);
  bool ordered = a != b ? a < b : wfvOrdered(wfvP[i], wfvP[j]);
  vec3 p = ordered ? wfvP[i] : wfvP[j];
  vec3 q = ordered ? wfvP[j] : wfvP[i];
  vec3 n = cross(p, q - p);
  return ordered ? n : -n;
}

// (No index is computed: that would put the corners into memory.)
vec4 wfvTrianglePlane(vec3 lengths)
{
  int nearest = lengths.x < lengths.y ? 0 : 1;
  nearest = lengths.z < min(lengths.x, lengths.y) ? 2 : nearest;
  vec3 normal = cross(wfvP[1] - wfvP[0], wfvP[2] - wfvP[0]);
  float w = dot(normal, nearest == 0 ? wfvP[0] : (nearest == 1 ? wfvP[1] : wfvP[2]));
  wfvD = wfvTowardOf(lengths);
  wfvM = vec2(dot(normal, wfvD), w);
  return vec4(normal, w);
}
