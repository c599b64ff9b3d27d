// SPDX-License-Identifier: BSD-3-Clause
// Lines, geometry stage, of maps by angles: arcs that curve little, and others.

// Emits the one rectangle of an arc that curves little; false where it does not.
bool wfvEmitGentle()
{
  float lo = wfvArcRange.x;
  float hi = wfvArcRange.y;
  WfvStretch s = wfvMeasure(lo, hi, wfvArcRef(lo, hi));
  wfvModeOut = wfvModeOf(s);
  if (wfvModeOut == 2 || !wfvChordHolds(s, lo, hi) || wfvSeamAngle() < WFV_NO_CUT)
  {
    return false;
  }
  wfvEmitStretch(s);
  return true;
}

void wfvEmitArc(bool dots)
{
#if WFV_FLAT_RIM
  // behind the rim there is no place in the map
  wfvKeepHalf(-wfvArcTop.z, -wfvArcSide.z);
#endif
  if (dots)
  {
    wfvEmitDots();
  }
  else if (wfvArcRange.x <= wfvArcRange.y && !wfvEmitGentle())
  {
    wfvEmitHard();
  }
}
