// SPDX-License-Identifier: BSD-3-Clause
// Stereographic: r = 2 tan(theta/2). Conformal; circles stay circles. Source: Snyder, Map
// Projections: A Working Manual (1987), chapter 21. Domain: up to 160 degrees from the
// axis; the antipode +z is infinitely far away.

const float WFV_MOST_FOV = 320.0; // degrees
const float WFV_STEREOGRAPHIC_END = 2.7925268031909272;   // 160 degrees
const float WFV_STEREOGRAPHIC_RIM = 11.342563639235415;   // 2 tan(80 degrees)
const float WFV_STEREOGRAPHIC_SLOPE = 33.163437477526331; // 1 / cos^2(80 degrees)

// Radius in the raw map of the angle theta in radians; beyond the domain it grows on
// evenly.
WFV_FN float wfvRadius(float theta, WfvView v)
{
  float beyond = theta - WFV_STEREOGRAPHIC_END;
  vec2 sc = wfvSinCos(0.5 * theta);
  return beyond > 0.0 ? WFV_STEREOGRAPHIC_RIM + WFV_STEREOGRAPHIC_SLOPE * beyond
                      : 2.0 * sc.x / sc.y;
}

WFV_FN float wfvTheta(float r, WfvView v)
{
  return 2.0 * wfvAtan2(r, 2.0);
}

WFV_FN float wfvThetaAt(vec2 m, float r, WfvView v)
{
  return wfvTheta(r, v);
}
