// SPDX-License-Identifier: BSD-3-Clause
// How many chords stand for each edge of this triangle (Classifier::Triangle).

// Of every triangle that is drawn, the number of limits.glsl.
uniform usamplerBuffer wfvChords;
uniform bool wfvHasChords; // of this draw; else no chord stands for an edge

int wfvReadCode()
{
  return wfvHasChords ? int(texelFetch(wfvChords, gl_PrimitiveIDIn).x) : 0;
}

ivec3 wfvReadChords()
{
  int code = wfvReadCode();
  return ivec3(wfvChordsInCode(0, code), wfvChordsInCode(1, code), wfvChordsInCode(2, code));
}
