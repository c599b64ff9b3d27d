// SPDX-License-Identifier: BSD-3-Clause
// What the stages' C++ and their shaders both know: compiled as both (Shaders/Limits.h).

// Samples of a pixel that are looked at, at the most.
const int WFV_MOST_SAMPLES = 16;

// Pieces of an edge that is tessellated, at the most: so many every OpenGL has.
const int WFV_MOST_PIECES = 64;

// How many chords stand for the edges of a triangle is one number: so many bits for the edge opposite
// to each corner.
const int WFV_CHORD_BITS = 6;

// Rows of a strip that the geometry stage cuts one triangle into at the most. One that takes more is drawn
// so many times, each of them a part of it; above the chords are the bits of its number.
const int WFV_ROWS_OF_PART = 16;

// The part of that number which is of one edge.
WFV_FN int wfvCodeOfChords(int edge, int chords)
{
  return chords << (WFV_CHORD_BITS * edge);
}

WFV_FN int wfvCodeOfPart(int part)
{
  return part << (3 * WFV_CHORD_BITS);
}

WFV_FN int wfvPartInCode(int code)
{
  return code >> (3 * WFV_CHORD_BITS);
}

WFV_FN int wfvChordsInCode(int edge, int code)
{
  return (code >> (WFV_CHORD_BITS * edge)) & ((1 << WFV_CHORD_BITS) - 1);
}
