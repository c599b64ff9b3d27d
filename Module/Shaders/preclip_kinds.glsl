// SPDX-License-Identifier: BSD-3-Clause
// Debug view: what the pre-clip did to a triangle.

int wfvSplitKind(bool seam)
{
#if WFV_MERIDIAN
  float low = min(wfvP[0].x, min(wfvP[1].x, wfvP[2].x));
  float high = max(wfvP[0].x, max(wfvP[1].x, wfvP[2].x));
  return seam && low < 0.0 && high > 0.0 ? WFV_KIND_REAR : WFV_KIND_PLAIN;
#else
  return WFV_KIND_PLAIN;
#endif
}

int wfvCoverKind(bool tear, float facing)
{
#if WFV_EXACT
  return WFV_KIND_EXACT;
#elif WFV_MERIDIAN
  bool pole = wfvHolds(1, 1.0, facing) || wfvHolds(1, -1.0, facing);
#else
  bool pole = wfvHolds(2, 1.0, facing);
#endif
#if !WFV_EXACT
  return pole || tear ? WFV_KIND_POLE : WFV_KIND_EXACT;
#endif
}
