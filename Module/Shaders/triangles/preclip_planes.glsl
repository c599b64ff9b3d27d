// SPDX-License-Identifier: BSD-3-Clause
// Pre-clip of triangles: the planes through the eye and each edge, and the triangle's own: what does
// not depend on whether OpenGL has doubles.

// Of the nearest corner's distance: a triangle with a longer edge may pass the eye much nearer
// than its corners do.
const float WFV_LONG = 0.5;

bool wfvIsLong(vec3 lengths)
{
  float nearest = min(lengths.x, min(lengths.y, lengths.z));
  vec3 edges = vec3(length(wfvP[2] - wfvP[1]), length(wfvP[0] - wfvP[2]), length(wfvP[1] - wfvP[0]));
  return max(edges.x, max(edges.y, edges.z)) > WFV_LONG * nearest;
}

// Of a small triangle the direction to one of its corners, for the fragment stage.
vec3 wfvTowardOf(vec3 lengths)
{
  return wfvIsLong(lengths) ? vec3(0.0) : wfvP[0] / lengths.x;
}
