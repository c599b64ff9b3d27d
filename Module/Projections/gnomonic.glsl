// SPDX-License-Identifier: BSD-3-Clause
// Gnomonic (rectilinear fisheye): r = tan(theta), the map of the perspective in a circle, drawn as
// all round maps are. Straight lines stay straight. Source: Snyder, Map Projections: A Working Manual
// (1987), chapter 22. Domain: up to 80 degrees from the axis; at 90 the map is infinitely far away.

WFV_FN float wfvRadius(float theta, WfvView v)
{
  return wfvIdeal(theta);
}

WFV_FN float wfvTheta(float r, WfvView v)
{
  return wfvIdealTheta(r);
}

WFV_FN float wfvThetaAt(vec2 m, float r, WfvView v)
{
  return wfvTheta(r, v);
}
