// SPDX-License-Identifier: BSD-3-Clause
// Lines, geometry stage, of rays from one centre: arcs of great circles.

bool wfvLineSingular(vec3 a, vec3 b)
{
#if WFV_FACES
  return false;
#elif WFV_FLAT_RIM
  if (max(a.z, b.z) > -WFV_LINE_RIM)
  {
    return true;
  }
#endif
  float s = wfvLineSingularSine();
#if WFV_MERIDIAN
  return wfvNears(a, b, vec3(0.0, 1.0, 0.0), s) || wfvNears(a, b, vec3(0.0, -1.0, 0.0), s);
#else
  return wfvNears(a, b, vec3(0.0, 0.0, 1.0), s);
#endif
}

// A rectangle round the image of a stretch on which both angles are monotonous.
void wfvEmitAngles(float lo, float hi, float ref)
{
  vec2 p = wfvArcAngles(wfvArcAt(lo), ref);
  vec2 q = wfvArcAngles(wfvArcAt(hi), ref);
  vec2 pad = vec2(WFV_LINE_ANGLE_PAD, wfvLevel ? WFV_LEVEL_PAD : WFV_LINE_ANGLE_PAD);
  vec4 r = vec4(min(p, q) - pad, max(p, q) + pad);
  wfvEmitBounds(r);
}

// True where the chord of a stretch, grown, surely holds its image.
bool wfvChordHolds(WfvStretch s, float lo, float hi)
{
  return cos(hi - lo) > WFV_LINE_LONG && !wfvLineSingular(wfvArcAt(lo), wfvArcAt(hi)) &&
    WFV_LINE_EXPANSION * s.sagitta <= 0.25 * min(wfvViewport.z, wfvViewport.w);
}

void wfvEmitHard()
{
  wfvModeOut = 2;
  wfvFrameTop();
  wfvArcCut = wfvArcJump ? wfvArcCut : wfvSeamAngle();
  wfvEmitRange();
}

// A line through the eye: nothing between its two ends can be seen.
void wfvEmitDots()
{
  wfvModeOut = 3;
  for (int i = 0; i < 2; i++)
  {
    float a = wfvArcEnds[i];
    if (a < wfvArcRange.x || a > wfvArcRange.y)
    {
      continue;
    }
    wfvMapOut = vec4(WFV_NO_CUT, 1.0, i == 0 ? -WFV_NO_CUT : 0.0, i == 0 ? 0.0 : WFV_NO_CUT);
    vec2 p = wfvArcPixel(a, wfvArcRef(a, a));
    wfvEmitAlong(p, p, wfvLineGrow());
  }
}
