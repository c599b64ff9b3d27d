// SPDX-License-Identifier: BSD-3-Clause
// Pre-clip of triangles: where its edges cross a straight seam.

flat out vec4 wfvSeam; // three heights, and the seam's x

void wfvWriteSeam()
{
  wfvSeam = wfvSeamPlaces;
}
