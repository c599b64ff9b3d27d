// SPDX-License-Identifier: BSD-3-Clause
// Lines, geometry stage, of an eye whose rays begin on a circle: the shapes of line_geometry.glsl for
// an image that is no great circle's.

// True where the chord of a stretch, grown, surely holds its image.
bool wfvChordHolds(WfvStretch s, float lo, float hi)
{
  bool flat_ = false;
#if WFV_FLAT_RIM
  flat_ = max(wfvArcAt(lo).z, wfvArcAt(hi).z) > -WFV_LINE_RIM;
#endif
  return cos(hi - lo) > WFV_LINE_LONG && !flat_ && !wfvNcWindow &&
    !wfvNcSingular(lo, hi, wfvLineSingularSine()) &&
    WFV_LINE_EXPANSION * s.sagitta <= 0.25 * min(wfvViewport.z, wfvViewport.w);
}

// The angle of place i of a stretch, dense near the top as knots are.
float wfvNcBetween(float lo, float hi, int i)
{
  vec2 turns = vec2(wfvAsinh(lo / wfvArcDelta), wfvAsinh(hi / wfvArcDelta));
  float a = wfvFromTop(mix(turns.x, turns.y, float(i) / float(WFV_NC_PARTS)));
  return i == 0 ? lo : (i == WFV_NC_PARTS ? hi : a);
}

// A rectangle round the image of a stretch.
void wfvEmitAngles(float lo, float hi, float ref)
{
  vec2 last = wfvArcAngles(wfvArcAt(lo), ref);
  vec4 r = vec4(last, last);
  vec2 change = vec2(WFV_LINE_ANGLE_PAD);
  for (int i = 1; i <= WFV_NC_PARTS; i++)
  {
    vec2 p = wfvArcAngles(wfvArcAt(wfvNcBetween(lo, hi, i)), ref);
    r = vec4(min(r.xy, p), max(r.zw, p));
    change = max(change, WFV_NC_BETWEEN * abs(p - last));
    last = p;
  }
  // the extreme latitude
  vec2 top = wfvArcAngles(wfvArcAt(clamp(0.0, lo, hi)), ref);
  r = vec4(r.x, min(r.y, top.y), r.z, max(r.w, top.y)) + vec4(-change, change);
  wfvEmitBounds(r);
}

// The whole window, in which each pixel looks at all of the range.
void wfvEmitAnywhere()
{
  vec2 own = wfvHasGap() ? wfvArcInner : vec2(-WFV_NO_CUT, WFV_NO_CUT);
  own = wfvTwoTops ? wfvArcTops : own;
  wfvMapOut = vec4(wfvArcCut, wfvTwoTops ? -wfvArcDelta : wfvArcDelta, own);
  wfvEmitWindow();
}

#if WFV_FACES
const int WFV_FACE_COUNT = 6;

// On one face, of which wfvArcRange is shown.
void wfvEmitOnFace()
{
  WfvStretch s = wfvMeasure(wfvArcRange.x, wfvArcRange.y, 0.0);
  wfvModeOut = wfvModeOf(s);
  if (wfvNcWindow || wfvNcSingular(wfvArcRange.x, wfvArcRange.y, wfvLineSingularSine()))
  {
    wfvModeOut = 2;
    wfvEmitAnywhere();
    return;
  }
  wfvModeOut = wfvModeOut == 2 ? 4 : wfvModeOut;
  wfvEmitStretch(s);
}

void wfvEmitSeen()
{
  wfvFrameTop();
  vec2 range = wfvArcRange;
  if (wfvQuadsLeft < WFV_FACE_COUNT)
  {
    // every pixel takes its own face
    wfvModeOut = 5;
    wfvEmitAnywhere();
    return;
  }
  for (int face = 0; face < WFV_FACE_COUNT; face++)
  {
    wfvArcFace = face;
    wfvArcRange = range;
    wfvKeepShown();
    if (wfvArcRange.x <= wfvArcRange.y)
    {
      wfvEmitOnFace();
    }
  }
}
#else
void wfvEmitHard()
{
  wfvModeOut = 2;
  wfvArcCut = wfvSeamAngle();
  wfvSetKnots();
  if (wfvNcWindow)
  {
    wfvEmitAnywhere();
    return;
  }
  wfvEmitRange();
}

#if WFV_FLAT_RIM
// Leaves of the range what the rim does, which is in one piece on either side of a gap alone.
void wfvKeepInFront()
{
  if (!wfvHasGap())
  {
    wfvKeepShown();
    return;
  }
  vec2 behind = vec2(max(wfvArcGap.y, wfvArcRange.x), wfvArcRange.y);
  wfvArcRange = vec2(wfvArcRange.x, min(wfvArcGap.x, wfvArcRange.y));
  wfvKeepShown();
  vec2 before = wfvArcRange;
  wfvArcRange = behind;
  wfvKeepShown();
  behind = wfvArcRange;
  bool first = before.x <= before.y;
  bool second = behind.x <= behind.y;
  wfvArcInner = first && second ? vec2(before.y, behind.x) : wfvArcGap;
  wfvArcRange = vec2(first ? before.x : behind.x, second ? behind.y : before.y);
}
#endif

void wfvEmitSeen()
{
#if WFV_FLAT_RIM
  wfvKeepInFront();
#endif
  if (!(wfvArcRange.x <= wfvArcRange.y))
  {
    return;
  }
  wfvFrameTop();
  float lo = wfvArcRange.x;
  float hi = wfvArcRange.y;
  WfvStretch s = wfvMeasure(lo, hi, wfvArcRef(lo, hi));
  wfvModeOut = wfvModeOf(s);
  if (wfvModeOut == 2 || !wfvChordHolds(s, lo, hi) || wfvSeamAngle() < WFV_NO_CUT)
  {
    wfvEmitHard();
    return;
  }
  wfvEmitStretch(s);
}
#endif
