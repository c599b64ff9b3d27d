// SPDX-License-Identifier: BSD-3-Clause
// Depth of a triangle that the vertex stage draws, seen by an eye whose rays begin in several
// places: that of the interpolated place, which lies on the triangle, from where its ray begins.
in vec3 wfvPlaceVSOutput; // as it is
in vec3 wfvSeenVSOutput;  // as this eye sees it, from the origin

float wfvDepth; // window depth here, 0 to 1
float wfvRho;   // distance along the ray, view coordinates

#define WFV_FROM_EYE normalize(wfvSeenVSOutput)

// For the data pass.
#define WFV_DISTANCE wfvRho

void wfvPrepareDepth()
{
  wfvRho = wfvSeenDistance(wfvPlaceVSOutput, wfvView);
  wfvDepth = wfvDepthOf(wfvRho * wfvBackYields(), wfvView);
}
