// SPDX-License-Identifier: BSD-3-Clause
// Pre-clip of triangles: its edges from end to end, where rays have no one centre.

flat out vec3 wfvSpan0; // opposite to corner i
flat out vec3 wfvSpan1;
flat out vec3 wfvSpan2;
vec3 wfvSpans[3];

void wfvWriteSpans()
{
  wfvSpan0 = wfvSpans[0];
  wfvSpan1 = wfvSpans[1];
  wfvSpan2 = wfvSpans[2];
}
