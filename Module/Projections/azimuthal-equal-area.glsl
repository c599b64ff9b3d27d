// SPDX-License-Identifier: BSD-3-Clause
// Azimuthal equal-area (Lambert; equisolid-angle fisheye): r = 2 sin(theta/2). Source:
// Snyder, Map Projections: A Working Manual (1987), chapter 24.
// Domain: the sphere. Discontinuity: the antipode +z, which becomes the outer circle.

// Radius in the raw map of the angle theta in radians.
WFV_FN float wfvRadius(float theta, WfvView v)
{
  return 2.0 * wfvSinCos(0.5 * theta).x;
}

WFV_FN float wfvTheta(float r, WfvView v)
{
  float s = min(1.0, 0.5 * r);
  return 2.0 * wfvAtan2(s, sqrt((1.0 - s) * (1.0 + s)));
}

WFV_FN float wfvThetaAt(vec2 m, float r, WfvView v)
{
  vec2 half_ = vec2(0.5 * m.x, 0.5 * m.y);
  return 2.0 * wfvAtan2(min(1.0, 0.5 * r), sqrt(wfvInsideCircle(half_)));
}
