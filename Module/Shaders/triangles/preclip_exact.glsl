// SPDX-License-Identifier: BSD-3-Clause
// Pre-clip of triangles that are all ray-tested.

void wfvDraw(bool seam, bool easy)
{
  bool near = easy && !seam;
  float grow = wfvChordBound + WFV_TIGHT_PAD; // as wfvEasy has measured
  wfvMustCover(!near || WFV_DEBUG_VIEW == 1);
  wfvVertexMode = WFV_RAY_TESTED;
#if WFV_DEBUG_VIEW
  wfvVertexMode += WFV_KIND_UNIT * wfvCoverKind(seam, seam && WFV_STRAIGHT_SEAM == 0);
#endif
  wfvCoverBy(near || (!seam && wfvIsNarrow()), near ? grow : wfvNarrowGrow());
}
