// SPDX-License-Identifier: BSD-3-Clause
// Gnomonic (rectilinear fisheye): r = tan(theta), the map of the perspective in a circle, drawn as
// all round maps are. Straight lines stay straight. Source: Snyder, Map Projections: A Working Manual
// (1987), chapter 22. Domain: up to 80 degrees from the axis; at 90 the map is infinitely far away.

const float WFV_MOST_FOV = 160.0; // degrees
const float WFV_GNOMONIC_END = 1.3962634015954636;   // 80 degrees
const float WFV_GNOMONIC_RIM = 5.6712818196177066;   // tan(80 degrees)
const float WFV_GNOMONIC_SLOPE = 33.163437477526330; // its first derivative
const float WFV_GNOMONIC_CURVATURE = 188.07920004232358;  // and half its second

// Radius in the raw map of the angle theta in radians; beyond the domain it grows on with the
// same curvature, which is largest there: chords that reach beyond are measured by it.
WFV_FN float wfvRadius(float theta, WfvView v)
{
  float beyond = theta - WFV_GNOMONIC_END;
  return beyond > 0.0
    ? WFV_GNOMONIC_RIM + beyond * (WFV_GNOMONIC_SLOPE + beyond * WFV_GNOMONIC_CURVATURE)
    : sin(theta) / cos(theta);
}

WFV_FN float wfvTheta(float r, WfvView v)
{
  return wfvAtan2(r, 1.0);
}

WFV_FN float wfvThetaAt(vec2 m, float r, WfvView v)
{
  return wfvTheta(r, v);
}
