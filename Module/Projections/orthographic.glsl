// SPDX-License-Identifier: BSD-3-Clause
// Orthographic (orthographic fisheye): r = sin(theta), the sphere seen from infinitely
// far away, from inside. Source: Snyder, Map Projections: A Working Manual (1987), chapter
// 20. Domain: the half sphere ahead, theta <= pi/2; at its rim the map is flat: r hardly
// tells angles apart. Discontinuity: none inside; the rim is where the sphere would fold.

// Radius in the raw map of the angle theta in radians; behind the eye it grows on, with
// the same slope at the rim, none, instead of folding back.
WFV_FN float wfvRadius(float theta, WfvView v)
{
  float beyond = theta - 0.5 * WFV_PI;
  return beyond > 0.0 ? 1.0 + 0.5 * beyond * beyond : wfvSinCos(theta).x;
}

WFV_FN float wfvTheta(float r, WfvView v)
{
  float s = min(1.0, r);
  return wfvAtan2(s, sqrt((1.0 - s) * (1.0 + s)));
}

WFV_FN float wfvThetaAt(vec2 m, float r, WfvView v)
{
  return wfvAtan2(min(1.0, r), sqrt(wfvInsideCircle(m)));
}
