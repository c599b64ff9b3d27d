// SPDX-License-Identifier: BSD-3-Clause
// How many chords stand for each edge of this triangle (Classifier::Triangle).

// Of every triangle that is drawn, five bits for the edge opposite to each corner.
uniform usamplerBuffer wfvChords;
uniform bool wfvHasChords; // of this draw; else no chord stands for an edge

ivec3 wfvReadChords()
{
  uint code = wfvHasChords ? texelFetch(wfvChords, gl_PrimitiveIDIn).x : 0u;
  return ivec3(code & 31u, (code >> 5u) & 31u, (code >> 10u) & 31u);
}
