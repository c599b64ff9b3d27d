// SPDX-License-Identifier: BSD-3-Clause
// Shared by the maps of rectilinear lenses: r = tan(theta), up to 80 degrees from the axis. Included
// before the projection. At 90 degrees it is infinitely far away.

const float WFV_MOST_FOV = 160.0; // degrees
const float WFV_GNOMONIC_END = 1.3962634015954636;   // 80 degrees
const float WFV_GNOMONIC_RIM = 5.6712818196177066;   // tan(80 degrees)
const float WFV_GNOMONIC_SLOPE = 33.163437477526330; // its first derivative
const float WFV_GNOMONIC_CURVATURE = 188.07920004232358;  // and half its second

// Radius of the angle theta in radians; beyond the domain it grows on with the same curvature, which is
// largest there: chords that reach beyond are measured by it.
WFV_FN float wfvIdeal(float theta)
{
  float beyond = theta - WFV_GNOMONIC_END;
  vec2 sc = wfvSinCos(theta);
  return beyond > 0.0
    ? WFV_GNOMONIC_RIM + beyond * (WFV_GNOMONIC_SLOPE + beyond * WFV_GNOMONIC_CURVATURE)
    : sc.x / sc.y;
}

WFV_FN float wfvIdealTheta(float r)
{
  return wfvAtan2(r, 1.0);
}
