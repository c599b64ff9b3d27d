// SPDX-License-Identifier: BSD-3-Clause
// Pre-clip of triangles: how it is drawn.

flat out int wfvMode; // bits: 1 ray-tested, more in wfvPlaceCorners

void wfvWriteMode()
{
  wfvMode = wfvVertexMode;
}
