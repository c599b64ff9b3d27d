// SPDX-License-Identifier: BSD-3-Clause
// Instead of chord_fragment.glsl where nothing is drawn by chords.

vec3 wfvChordErrors()
{
  return vec3(0.0);
}

vec3 wfvToChords(vec3 direction, vec3 e, vec3 dx, vec3 dy)
{
  return vec3(0.0);
}

// Inside the three edges.
bool wfvAllInside(vec3 e, vec3 toChords)
{
  return wfvInside(e.x, wfvEdge0) && wfvInside(e.y, wfvEdge1) && wfvInside(e.z, wfvEdge2);
}
