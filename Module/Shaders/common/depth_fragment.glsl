// SPDX-License-Identifier: BSD-3-Clause
// Depth of what the pre-clip does not cover (points, lines, props without a geometry
// stage), where the mapping is not what the rasterizer interpolates.
float wfvDepth = 0.0; // window depth here, 0 to 1
float wfvRho = 0.0; // distance from the eye here, in the stage's own units

// Of the distance: by so much at the most a face seen from behind is put back, more than the rasterizer errs
// when it interpolates places. Beside a silhouette a front and a back may meet in one pixel at one
// depth; the front shows.
const float WFV_BACK_BIAS = 2e-5;

// place: the fragment's, view coordinates; between the clip spheres, in whose units no square of it
// is too large or too small
void wfvPrepareDepth(vec3 place)
{
  place *= 1.0 / wfvScale();
  wfvRho = length(place);
  wfvDepth = wfvDepthInUnits(wfvRho * (gl_FrontFacing ? 1.0 : 1.0 + WFV_BACK_BIAS));
}
