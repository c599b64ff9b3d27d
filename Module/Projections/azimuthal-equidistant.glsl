// SPDX-License-Identifier: BSD-3-Clause
// Azimuthal equidistant (fisheye, dome): the distance from the centre is the angle
// theta from -z, r = theta / (fov/2), or the lens polynomial
// r = c1 theta + c2 theta^2 + .. + c9 theta^9. Source: Bailey, Clothier and Gebbie
// 2006, section 3. Domain: the sphere, or with a lens up to half the field of
// view. Discontinuity: the antipode +z, which becomes the outer circle.

WFV_FN float wfvIdeal(float theta)
{
  return theta;
}

WFV_FN float wfvIdealSlope(float theta)
{
  return 1.0;
}

WFV_FN float wfvIdealTheta(float r)
{
  return r;
}
