// SPDX-License-Identifier: BSD-3-Clause
// For depths that a rasterizer interpolates.

// Of the distance: by so much a face seen from behind is put back, more than the rasterizer errs
// when it interpolates places. Beside an outline a front and a back may meet in one pixel at one
// depth; the front shows.
const float WFV_BACK_YIELDS = 2e-5;

float wfvBackYields()
{
  return gl_FrontFacing ? 1.0 : 1.0 + WFV_BACK_YIELDS;
}
