// SPDX-License-Identifier: BSD-3-Clause
// The number of a triangle in its mapper, where some of its triangles are drawn by themselves
// (Frame/RefinedDraw.h) and the number in the draw is another.

uniform usamplerBuffer wfvNumbers;
uniform int wfvFirstNumber; // of this draw; -1: the numbers are the mapper's own

int wfvNumber()
{
  return wfvFirstNumber < 0 ? gl_PrimitiveID
                            : int(texelFetch(wfvNumbers, wfvFirstNumber + gl_PrimitiveID).x);
}
