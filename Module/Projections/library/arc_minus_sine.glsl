// SPDX-License-Identifier: BSD-3-Clause
// w - sin(w) for w in [0, pi], without the cancellation of small w. Included before the
// equal-area maps that need it beside their poles. Here and in all that is solved by steps, sines and
// cosines are wfvSinCos: Mesa 26 errs with its own in loops of a geometry stage, by pixels.

// Below it the series answers, above it the difference loses less than four bits.
const float WFV_SMALL_ARC = 1.0;

WFV_FN float wfvArcMinusSine(float w)
{
  float s = w * w;
  float series = 1.0 - s / 210.0 * (1.0 - s / 272.0);
  series = 1.0 - s / 72.0 * (1.0 - s / 110.0 * (1.0 - s / 156.0 * series));
  series = w * s / 6.0 * (1.0 - s / 20.0 * (1.0 - s / 42.0 * series));
  return w < WFV_SMALL_ARC ? series : w - wfvSinCos(w).x;
}

// One minus the size of the sine of the latitude, from its (cosine, sine).
WFV_FN float wfvPolarGap(vec2 phi)
{
  return phi.x * phi.x / (1.0 + abs(phi.y));
}

// (cosine, size of the sine) of the latitude from that gap.
WFV_FN vec2 wfvFromPolarGap(float gap)
{
  return vec2(max(WFV_AT_SINGULARITY, sqrt(max(0.0, gap * (2.0 - gap)))), 1.0 - gap);
}

// Size of the sine of the latitude beyond which the equations are solved from the pole:
// there their slope in the other variable vanishes.
const float WFV_POLAR_SIDE = 0.7;
