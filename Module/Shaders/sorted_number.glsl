// SPDX-License-Identifier: BSD-3-Clause
// The number of a triangle in its mapper, where those that are drawn are sorted
// (vtkWideFoVSorter.h) and the number in the draw is another.

uniform usamplerBuffer wfvNumbers;
uniform int wfvFirstNumber; // of this draw; -1: nothing is sorted

int wfvNumber()
{
  return wfvFirstNumber < 0 ? gl_PrimitiveID
                            : int(texelFetch(wfvNumbers, wfvFirstNumber + gl_PrimitiveID).x);
}
