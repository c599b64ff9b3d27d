// SPDX-License-Identifier: BSD-3-Clause
// Pre-clip of triangles: its corners in the picture, see chord_fragment.glsl.

flat out vec4 wfvCorners01;
flat out vec2 wfvCorner2;

void wfvWritePlaces()
{
  wfvCorners01 = vec4(wfvC[0], wfvC[1]);
  wfvCorner2 = wfvC[2];
}
