// SPDX-License-Identifier: BSD-3-Clause
// Brown-Conrady: a rectilinear lens as it was measured, r = c1 t + c2 t^2 + .. + c9 t^9 with
// t = tan(theta); without a lens the gnomonic map. Source: D. C. Brown, Decentering Distortion of
// Lenses (1966), its radial part: c1 = 1, c3 = k1, c5 = k2, c7 = k3. Domain: up to half the
// field of view, at the most 80 degrees from the axis. Discontinuity: none inside.

WFV_FN float wfvIdealSlope(float theta)
{
  float t = wfvIdeal(theta);
  return 1.0 + t * t;
}
