// SPDX-License-Identifier: BSD-3-Clause
// Depth of what the pre-clip does not cover (points, lines, props without a geometry
// stage), where the mapping is not what the rasterizer interpolates.
in vec3 wfvPlaceVSOutput;

float wfvDepth; // window depth here, 0 to 1

void wfvPrepareDepth()
{
  wfvDepth = wfvDepthOf(wfvLength(wfvPlaceVSOutput) * wfvBackYields(), wfvView);
}
