// SPDX-License-Identifier: BSD-3-Clause
// Lines, geometry stage, of an eye whose rays begin on a circle: where the image of a line is
// discontinuous or curves most.

// Radii of the circle: what passes its axis nearer than so many may curve much overhead and
// underfoot; and what is nearer to its middle is bounded by nothing less than the window.
const float WFV_NC_AXIS = 16.0;
const float WFV_NC_CLOSE = 1.5;

// Where the search for the top of a line begins, and its steps.
const int WFV_NC_FIRST = 32;
const int WFV_NC_STEPS = 30;

// Radians: the scale of the curves at the ends of a gap, where the image runs as the root of the angle.
const float WFV_GAP_DELTA = 1e-5;

// Sine under which both axes count, and radians by which they have to be apart on the line.
const float WFV_NC_BOTH = 0.7;
const float WFV_NC_APART = 0.02;

// What keeps the top in the middle of a line where nothing else draws it.
const float WFV_NC_NONE = 1e-3;

// Parts of a stretch at which its angles are looked at, and the share of the largest change from one
// to the next by which they may do more between.
const int WFV_NC_PARTS = 8;
const float WFV_NC_BETWEEN = 0.25;

// How curved the image may be where the line is at the angle a: the sine of the angle to the axis of
// the map or, for a line beside it, to that of the circle.
float wfvNcSine(float a)
{
  vec3 d = wfvArcAt(a);
#if WFV_MERIDIAN
  float s = wfvHypot(d.x, d.z);
#elif WFV_ROUND && !WFV_FLAT_RIM
  float s = d.z > 0.0 ? wfvHypot(d.x, d.y) : 1.0 + WFV_NC_NONE * abs(a);
#else
  float s = 1.0 + WFV_NC_NONE * abs(a);
#endif
  s = wfvNcMapped ? s : 1.0 + WFV_NC_NONE * abs(a);
  return wfvNcAxial ? min(s, length(cross(d, wfvUpright(wfvView)))) : s;
}

// The angle of the range at which that is least.
float wfvNcTop()
{
  float step_ = (wfvArcRange.y - wfvArcRange.x) / float(WFV_NC_FIRST);
  float best = 1e9;
  float at = wfvArcRange.x;
  for (int i = 0; i <= WFV_NC_FIRST; i++)
  {
    float a = min(wfvArcRange.x + float(i) * step_, wfvArcRange.y);
    float s = wfvNcSine(a);
    at = s < best ? a : at;
    best = min(best, s);
  }
  vec2 ends = clamp(vec2(at - step_, at + step_), wfvArcRange.x, wfvArcRange.y);
  for (int i = 0; i < WFV_NC_STEPS; i++)
  {
    vec2 inner = mix(ends.xx, ends.yy, vec2(1.0, 2.0) / 3.0);
    ends = wfvNcSine(inner.x) < wfvNcSine(inner.y) ? vec2(ends.x, inner.y)
                                                     : vec2(inner.x, ends.y);
  }
  float top = 0.5 * (ends.x + ends.y);
  // at an end of the range, to the last digit
  top = wfvNcSine(wfvArcRange.x) <= wfvNcSine(top) ? wfvArcRange.x : top;
  return wfvNcSine(wfvArcRange.y) < wfvNcSine(top) ? wfvArcRange.y : top;
}

// Where a gap leaves one part of the line: its end is one place, what is beside the axis of the map
// the other.
void wfvFindTopBesideGap()
{
  bool first = wfvArcGap.y >= wfvArcRange.y;
  if (!first && wfvArcGap.x > wfvArcRange.x)
  {
    return;
  }
  wfvArcRange = first ? vec2(wfvArcRange.x, min(wfvArcGap.x, wfvArcRange.y))
                      : vec2(max(wfvArcGap.y, wfvArcRange.x), wfvArcRange.y);
  float end = first ? wfvArcRange.y : wfvArcRange.x;
  float top = wfvNcTop();
  wfvArcTops = vec2(min(top, end), max(top, end));
  wfvTwoTops = wfvNcSine(top) < WFV_NC_BOTH && abs(top - end) > WFV_NC_APART;
}

// Looks for two places, beside either axis; sets wfvArcTops and, where both count, wfvTwoTops.
void wfvFindTwoTops()
{
  wfvNcMapped = false;
  float first = wfvNcTop();
  float s = wfvNcSine(first);
  wfvNcMapped = true;
  wfvNcAxial = false;
  float second = wfvNcTop();
  s = max(s, wfvNcSine(second));
  wfvNcAxial = true;
  wfvArcTops = vec2(min(first, second), max(first, second));
  wfvTwoTops = s < WFV_NC_BOTH && wfvArcTops.y - wfvArcTops.x > WFV_NC_APART;
}

// Turns the frame to there, for what wfvArcRange leaves of the line.
void wfvFrameTop()
{
  // the ends of a gap, at which the image turns most, are its knots
  if (wfvHasGap())
  {
    wfvFindTopBesideGap();
  }
  else if (wfvNcAxial)
  {
    wfvFindTwoTops();
  }
  float top = wfvNcTop();
  float sine = wfvNcSine(top);
  top = wfvTwoTops ? 0.5 * (wfvArcTops.x + wfvArcTops.y) : top;
  top = wfvHasGap() && !wfvTwoTops ? 0.5 * (wfvArcGap.x + wfvArcGap.y) : top;
  wfvTurnFrame(top);
  wfvArcTops -= top;
  wfvArcDelta = wfvHasGap() ? WFV_GAP_DELTA : clamp(sine, WFV_LEAST_DELTA, 1.0);
  vec3 nearest = wfvNcPlace(clamp(wfvArcFoot, wfvArcRange.x, wfvArcRange.y));
  wfvNcWindow = wfvHasGap() || wfvTwoTops || length(nearest) < WFV_NC_CLOSE * wfvNcRadius();
}

// True where what lies between two angles comes near to where a map or the circle curves without bound.
bool wfvNcSingular(float lo, float hi, float sine)
{
  float top = clamp(0.0, lo, hi);
  return min(wfvNcSine(top), min(wfvNcSine(lo), wfvNcSine(hi))) < sine;
}

// Angle at which the image crosses a seam that is not straight, or jumps over the top, or WFV_NO_CUT.
float wfvSeamAngle()
{
  bool inside = wfvArcRange.x < 0.0 && wfvArcRange.y > 0.0;
  float cut = inside && !wfvHasGap() && wfvArcDelta <= WFV_LEAST_DELTA ? 0.0 : WFV_NO_CUT;
#if WFV_MERIDIAN && !WFV_STRAIGHT_SEAM
  float a = wfvArcRange.x;
  float x = wfvArcAt(a).x;
  wfvSetKnots();
  for (int i = 1; i <= 4 * WFV_KNOTS; i++)
  {
    float b = i == 4 * WFV_KNOTS ? wfvArcRange.y : wfvKnot(i);
    float y = wfvArcAt(b).x;
    float lo = a;
    float hi = b;
    bool gap = wfvHasGap() && a < wfvArcGap.y && b > wfvArcGap.x;
    bool crosses = (x < 0.0) != (y < 0.0) && !gap;
    for (int k = 0; k < (crosses ? WFV_NC_CUTS : 0); k++)
    {
      float m = 0.5 * (lo + hi);
      bool same = (wfvArcAt(m).x < 0.0) == (x < 0.0);
      lo = same ? m : lo;
      hi = same ? hi : m;
    }
    cut = crosses && cut == WFV_NO_CUT && wfvArcAt(hi).z > 0.0 ? hi : cut;
    a = b;
    x = y;
  }
#endif
  return cut;
}

// Emits what wfvArcRange leaves.
void wfvEmitSeen(); // line_noncentral_geometry.glsl

void wfvEmitNc(vec3 p, vec3 q)
{
  wfvFrameNc(p, q);
  float at = wfvAngleAtAxis();
  wfvNcAxial = wfvFromAxis(wfvNcPlace(at)) < WFV_NC_AXIS * wfvNcRadius();
  if (!wfvIsSeen(at))
  {
    wfvArcGap = wfvFindGap(at);
    wfvArcInner = wfvArcGap;
    if (wfvArcGap.x <= wfvArcEnds.x && wfvArcGap.y >= wfvArcEnds.y)
    {
      return;
    }
    wfvNcAxial = false;
  }
  wfvEmitSeen();
}
