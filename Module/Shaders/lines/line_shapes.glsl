// SPDX-License-Identifier: BSD-3-Clause
// Lines, geometry stage: rectangles round the image of a part of an arc, along its chord or round
// its angles.

// Factor on the sampled distance of an arc from its chord, for the shape round it.
const float WFV_LINE_EXPANSION = 1.8;

// Largest ratio of half the width to the radius of the image's curvature for which the
// nearest point is found by Newton's steps from the chord.
const float WFV_LINE_CURVATURE = 0.25;

// Largest sagitta, over the length of the chord, for the same.
const float WFV_LINE_SAGITTA = 0.05;

// Pixels: a sagitta so small is none, whatever the length of the chord.
const float WFV_LINE_FLAT = 0.05;

// Pixels: the largest distance of a chord that may stand for its arc.
const float WFV_LINE_STRAIGHT = 0.005;

// Radians: room round a rectangle of angles for their rounding.
const float WFV_LINE_ANGLE_PAD = 2e-6;

// Cosine of the longest arc that is measured by three points between its ends: 60 degrees.
const float WFV_LINE_LONG = 0.5;

// Distance, in pixels, of p from the line through a and b.
float wfvFromChord(vec2 a, vec2 b, vec2 p)
{
  vec2 ab = b - a;
  float l = length(ab);
  return l > 0.01 ? abs(ab.x * (p - a).y - ab.y * (p - a).x) / l : length(p - a);
}

// The image of a stretch of the arc: its ends, and how far it stays from their chord by
// three points between them.
struct WfvStretch
{
  vec2 from;
  vec2 to;
  float sagitta;
};

WfvStretch wfvMeasure(float lo, float hi, float ref)
{
  WfvStretch s;
  s.from = wfvArcPixel(lo, ref);
  s.to = wfvArcPixel(hi, ref);
  s.sagitta = 0.0;
  for (int i = 1; i < 4; i++)
  {
    vec2 p = wfvArcPixel(mix(lo, hi, 0.25 * float(i)), ref);
    s.sagitta = max(s.sagitta, wfvFromChord(s.from, s.to, p));
  }
  return s;
}

// Cosine of the angle from the axis beyond which nothing is measured by few points where a map
// is flat at its rim: there arcs turn within a few pixels.
const float WFV_LINE_RIM = 0.2;

// Sine of the angle from the axis inside which nothing is measured by few points.
float wfvLineSingularSine()
{
  return max(wfvSingularSine(), sin(min(1.0, (wfvLineWidth + 4.0) * wfvPixelAngle())));
}

void wfvEmitWindow()
{
  wfvEmitPixels(-0.5 * wfvViewport.zw, vec2(wfvViewport.z, 0.0), vec2(0.0, wfvViewport.w));
}

// The rectangle round what a rectangle of angles shows, grown.
void wfvEmitBounds(vec4 r)
{
#if WFV_MERIDIAN
  r = vec4(r.x, max(r.y, -0.5 * WFV_PI), r.z, min(r.w, 0.5 * WFV_PI));
#if !WFV_STRAIGHT_SEAM
  r = vec4(max(r.x, -WFV_PI), r.y, min(r.z, WFV_PI), r.w);
#endif
#else
  r = vec4(r.x, max(r.y, 0.0), r.z, min(r.w, WFV_PI));
#endif
  r = wfvBounds(r, wfvView);
  vec2 low = wfvTilePixel(r.xy) - wfvLineGrow();
  vec2 size = wfvTilePixel(r.zw) + wfvLineGrow() - low;
  wfvEmitRound(low, vec2(size.x, 0.0), vec2(0.0, size.y));
}

// line_central.glsl, line_noncentral_geometry.glsl
bool wfvChordHolds(WfvStretch s, float lo, float hi);
void wfvEmitAngles(float lo, float hi, float ref);

// The parts between two angles, at the knots of line_arc.glsl.
void wfvEmitParts(float from, float to, float ref)
{
  int step_ = wfvQuadsLeft >= 10 ? WFV_KNOTS / 2 : WFV_KNOTS;
  float lo = from;
  for (int i = step_; i <= 4 * WFV_KNOTS; i += step_)
  {
    float hi = clamp(wfvKnot(i), from, to);
    hi = i == 4 * WFV_KNOTS ? to : hi;
    if (!(hi > lo))
    {
      continue;
    }
    bool room = wfvQuadsLeft > 4 || (wfvQuadsLeft > 1 && hi == wfvArcRange.y);
    hi = room ? hi : wfvArcRange.y;
    float first = lo == wfvArcRange.x ? -WFV_NO_CUT : lo;
    wfvMapOut = vec4(wfvArcCut, wfvArcJump ? -wfvArcDelta : wfvArcDelta, first,
      hi == wfvArcRange.y ? WFV_NO_CUT : hi);
    if (!room)
    {
      wfvEmitWindow();
      wfvQuadsLeft = 0;
      return;
    }
    WfvStretch s = wfvMeasure(lo, hi, ref);
    if (wfvChordHolds(s, lo, hi))
    {
      wfvEmitAlong(s.from, s.to, wfvLineGrow() + WFV_LINE_EXPANSION * s.sagitta);
    }
    else
    {
      wfvEmitAngles(lo, hi, ref);
    }
    lo = hi;
  }
}

// All of the range, in two where the map is cut.
void wfvEmitRange()
{
  float a0 = wfvArcRange.x;
  float a1 = wfvArcRange.y;
  if (wfvArcCut < WFV_NO_CUT)
  {
    wfvEmitParts(a0, wfvArcCut, wfvArcRef(a0, wfvArcCut));
    a0 = wfvArcCut;
  }
  wfvEmitParts(a0, a1, wfvArcRef(a0, a1));
}

// The mode of a stretch whose chord, grown, holds it; 2 where neither of the first two will do.
int wfvModeOf(WfvStretch s)
{
  float l = length(s.to - s.from);
  bool gentle = s.sagitta <= WFV_LINE_FLAT ||
    (s.sagitta <= WFV_LINE_SAGITTA * l && 4.0 * s.sagitta * wfvLineWidth <= WFV_LINE_CURVATURE * l * l);
  return s.sagitta <= WFV_LINE_STRAIGHT ? 0 : (gentle ? 1 : 2);
}

void wfvEmitStretch(WfvStretch s)
{
  wfvMapOut = vec4(s.from, s.to);
  wfvEmitAlong(s.from, s.to, wfvLineGrow() + (wfvModeOut == 0 ? 0.0 : WFV_LINE_EXPANSION * s.sagitta));
}
