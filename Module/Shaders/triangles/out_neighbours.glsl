// SPDX-License-Identifier: BSD-3-Clause
// Pre-clip of triangles: where it ends, for neighbours may be drawn by their chords: at those of its edges whose
// chord error is within the tolerance (chord_fragment.glsl).

flat out vec3 wfvSlack; // pixels between edge i and its chord, at the most; < 0: it ends at the edge
vec3 wfvSlackHere = vec3(-1.0);
vec3 wfvCountHere = vec3(0.0);
#define WFV_LENS wfvTolerance

void wfvWriteSlack()
{
  wfvSlack = wfvSlackHere;
}

// An edge that chords stand for ends there; another is as it is.
void wfvFindChords()
{
  ivec3 chords = wfvReadChords();
  wfvCountHere = vec3(chords);
  for (int i = 0; i < 3; i++)
  {
    wfvSlackHere[i] = chords[i] > 0 ? wfvTolerance : -1.0;
  }
}
