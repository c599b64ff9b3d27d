// SPDX-License-Identifier: BSD-3-Clause
// Debug view: what the pre-clip did to a triangle, or would do where all go by rays.

int wfvSplitKind(bool seam)
{
#if WFV_MERIDIAN
  float low = min(wfvP[0].x, min(wfvP[1].x, wfvP[2].x));
  float high = max(wfvP[0].x, max(wfvP[1].x, wfvP[2].x));
  return seam && low < 0.0 && high > 0.0 ? WFV_KIND_REAR : WFV_KIND_STRAIGHT;
#else
  return WFV_KIND_STRAIGHT;
#endif
}

// Of a triangle that wfvMustCover has measured.
int wfvCoverKind(bool seam, bool discontinuous)
{
#if WFV_MERIDIAN
  bool pole = wfvHolds(1, 1.0) || wfvHolds(1, -1.0);
#else
  bool pole = wfvHolds(2, 1.0);
#endif
#if WFV_BY_RAYS
  return pole || discontinuous ? WFV_KIND_POLE : wfvCurved ? WFV_KIND_EXACT : wfvSplitKind(seam);
#elif WFV_EXACT
  return WFV_KIND_EXACT;
#else
  return pole || discontinuous ? WFV_KIND_POLE : WFV_KIND_EXACT;
#endif
}
