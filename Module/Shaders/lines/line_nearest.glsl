// SPDX-License-Identifier: BSD-3-Clause
// Fragment side of lines, technique exact: the point of an arc of any kind that is nearest in
// the map, by Newton's method from the chords between its knots.

// Distance of p from the image of the arc, pixels.
float wfvDistance(vec2 p, int steps)
{
  wfvBestDistance = 1e9;
  for (int i = 0; i < wfvStartCount; i++)
  {
    wfvRefine(p, i, steps);
  }
#if WFV_FLAT_RIM
  // at the rim an arc turns within a few pixels: its end may be as near as what lies before
  float ref = wfvArcRef(wfvArcRange.x, wfvArcRange.y);
  for (int i = 0; i < 2; i++)
  {
    wfvTry(p, wfvArcRange[i], ref);
#if WFV_NON_CENTRAL
    wfvTry(p, clamp(wfvArcInner[i], wfvArcRange.x, wfvArcRange.y), ref);
#endif
  }
#endif
  return wfvBestDistance;
}

// Finds the point of the line nearest to p; its distance from p, or what is more than any
// width where another part of the line's shape draws it.
float wfvFindNearest(vec2 p)
{
  wfvBeforeCut = wfvArcCut - WFV_CUT_GAP;
  if (wfvLineKind == 0)
  {
    return wfvChordDistance(p);
  }
  if (wfvLineKind == 1)
  {
    wfvStartOnChord(p);
  }
  else if (wfvLineKind == 2)
  {
    wfvStartAnywhere(p);
  }
  else if (wfvLineKind > 3)
  {
    wfvStartOnFace(p);
  }
  else
  {
    wfvStartDots();
  }
  float d = wfvDistance(p, WFV_LINE_STEPS);
  bool whole = wfvLineKind == 1 || wfvLineKind > 3;
#if WFV_NON_CENTRAL
  whole = whole || wfvHasGap() || wfvTwoTops;
#endif
  bool own = whole || (wfvBestAngle >= wfvLineMap.z && wfvBestAngle < wfvLineMap.w);
  return own ? d : 1e9;
}

float wfvSampleDistance(vec2 p)
{
  return wfvLineKind == 0 ? wfvChordDistance(p) : wfvDistance(p, WFV_LINE_SAMPLE_STEPS);
}
