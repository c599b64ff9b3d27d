// SPDX-License-Identifier: BSD-3-Clause
// Fragment side of the squares of point_geometry.glsl.
flat in float wfvPointDepth;
in vec2 wfvPointCoord;

float wfvDepth = 0.0; // window depth, 0 to 1
const bool wfvHide = false; // the square is all there is to see
const bool wfvFront = true; // as points are

void wfvInterpolate(); // generated: sets the stock shader's inputs

void wfvPrepare()
{
  wfvDepth = wfvPointDepth;
  wfvInterpolate();
}
