// SPDX-License-Identifier: BSD-3-Clause
// Pre-clip of triangles that may be drawn by their chords: which are, and which are ray-tested.

void wfvEmitSides(bool seam)
{
#if WFV_MERIDIAN
  float low = min(wfvP[0].x, min(wfvP[1].x, wfvP[2].x));
  float high = max(wfvP[0].x, max(wfvP[1].x, wfvP[2].x));
  if (seam && low < 0.0 && high > 0.0)
  {
    wfvEmitSide(1.0);
    wfvEmitSide(-1.0);
    return;
  }
  wfvEmitWhole(seam ? (high > 0.0 ? 1.0 : -1.0) : 0.0);
#else
  wfvEmitWhole(0.0);
#endif
}

// Of a triangle that wfvMustCover has measured.
void wfvCoverCurved(bool seam, bool discontinuous)
{
  wfvVertexMode = WFV_RAY_TESTED;
  wfvPlaceCorners(seam);
#if WFV_DEBUG_VIEW
  wfvVertexMode += WFV_KIND_UNIT * wfvCoverKind(seam, discontinuous);
#endif
  wfvCoverBy(!seam && wfvIsNarrow(), wfvNarrowGrow());
}

void wfvDraw(bool seam, bool easy)
{
  bool discontinuous = seam && WFV_STRAIGHT_SEAM == 0;
  // wfvMustCover also prepares the covering: it runs wherever one may follow
  if ((discontinuous || !easy) && (wfvMustCover(true) || discontinuous))
  {
    wfvCoverCurved(seam, discontinuous);
    return;
  }
  wfvVertexMode = 0;
#if WFV_DEBUG_VIEW
  wfvVertexMode += WFV_KIND_UNIT * wfvSplitKind(seam);
#endif
  wfvEmitSides(seam);
}
