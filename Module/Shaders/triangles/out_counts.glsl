// SPDX-License-Identifier: BSD-3-Clause
// Pre-clip of triangles: of how many chords its edges are.

flat out vec3 wfvCount; // of the chords of edge i
flat out vec3 wfvPlace0; // the corners, that chords lie between
flat out vec3 wfvPlace1;
flat out vec3 wfvPlace2;

void wfvWriteCounts()
{
  wfvCount = wfvCountHere;
  wfvPlace0 = wfvP[0];
  wfvPlace1 = wfvP[1];
  wfvPlace2 = wfvP[2];
}
