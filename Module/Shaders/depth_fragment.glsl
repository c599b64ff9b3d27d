// SPDX-License-Identifier: BSD-3-Clause
// Depth of what the pre-clip does not cover (points, lines, props without a geometry
// stage), where the mapping is not what the rasterizer interpolates.
in vec3 wfvPlaceVSOutput;

float wfvDepth; // window depth here, 0 to 1

// Of the distance: by so much a face seen from behind is put back, more than the rasterizer errs
// when it interpolates places. Beside an outline a front and a back may meet in one pixel at one
// depth; the front shows.
const float WFV_BACK_YIELDS = 2e-5;

void wfvPrepareDepth()
{
  float back = gl_FrontFacing ? 1.0 : 1.0 + WFV_BACK_YIELDS;
  wfvDepth = wfvDepthOf(wfvLength(wfvPlaceVSOutput) * back, wfvView);
}
