// SPDX-License-Identifier: BSD-3-Clause
// Depth between the clip spheres as a function of the distance from the eye, and back.
// Every mapping grows with the distance, from 0 on the near to 1 on the far sphere, as
// VTK's depth test, clear value and passes expect. WFV_DEPTH_MAPPING(v) is the view's mapping,
// a constant in the shaders.

const int WFV_DEPTH_LINEAR = 0;      // the same step everywhere
const int WFV_DEPTH_LOGARITHMIC = 1; // a step is the same part of the distance everywhere
const int WFV_DEPTH_REVERSED = 2;    // of 1 / distance, as a perspective's: finest nearby

WFV_FN float wfvLinearDepth(float rho, WfvView v)
{
  return (rho - v.radii.x) / (v.radii.y - v.radii.x);
}

// rho at or below 0 (the eye itself) is in front of the near sphere.
WFV_FN float wfvDepthOf(float rho, WfvView v)
{
  float near = v.radii.x;
  float far = v.radii.y;
  if (WFV_DEPTH_MAPPING(v) == WFV_DEPTH_LINEAR || !(rho > 0.0))
  {
    return wfvLinearDepth(rho, v);
  }
  if (WFV_DEPTH_MAPPING(v) == WFV_DEPTH_LOGARITHMIC)
  {
    return wfvLog(rho / near) / wfvLog(far / near);
  }
  // (1/near - 1/rho) / (1/near - 1/far), without reciprocals that cancel
  return wfvLinearDepth(rho, v) * (far / rho);
}

WFV_FN float wfvDistanceAt(float depth, WfvView v)
{
  float near = v.radii.x;
  float far = v.radii.y;
  if (WFV_DEPTH_MAPPING(v) == WFV_DEPTH_LINEAR)
  {
    return near + depth * (far - near);
  }
  if (WFV_DEPTH_MAPPING(v) == WFV_DEPTH_LOGARITHMIC)
  {
    return near * exp(depth * wfvLog(far / near));
  }
  return near * far / (far - depth * (far - near));
}
