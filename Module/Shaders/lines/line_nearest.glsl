// SPDX-License-Identifier: BSD-3-Clause
// Fragment side of lines, technique exact: the point of an arc of any kind that is nearest in
// the map, by Newton's method from the chords between its knots.

// A place on the arc to start from: angle and the range in which the image is in one
// piece; the azimuth this is continued from.
struct WfvStart
{
  float a;
  float lo;
  float hi;
  float ref;
};

WfvStart wfvStarts[2];
int wfvStartCount = 0;

// Radians by which the part in front of a jump ends before it: a nearest point at the jump
// then belongs to one part, whose shape is on the right side.
const float WFV_CUT_GAP = 1e-6;
float wfvBeforeCut = 0.0;

// Newton's steps: from a chord, and from the centre of the pixel to a sample of it.
#if WFV_FLAT_RIM
const int WFV_LINE_STEPS = 12;
#else
const int WFV_LINE_STEPS = 5;
#endif
const int WFV_LINE_SAMPLE_STEPS = 2;

// Pixels: behind a step so short one more is the last.
const float WFV_LINE_STEP = 0.002;

// Pixels of the differences, each way, by which slopes are measured.
const float WFV_LINE_DIFFERENCE = 2.0;

// Smallest share of the squared speed that stays of it where the image curves away.
const float WFV_LINE_DAMPING = 0.3;

// Largest step, in turns of wfvStepped.
const float WFV_LINE_LONGEST_STEP = 0.7;

// The angle `turn` farther on, in units that grow with the distance from where the image
// curves: the far from top, the larger.
float wfvStepped(float a, float turn)
{
  float base = abs(a) > 0.5 * WFV_PI ? (a < 0.0 ? -WFV_PI : WFV_PI) : 0.0;
#if WFV_NON_CENTRAL
  base = wfvHasGap() ? (a <= 0.0 ? wfvArcGap.x : wfvArcGap.y) : base;
  base = wfvTwoTops ? (a <= 0.0 ? wfvArcTops.x : wfvArcTops.y) : base;
#endif
  float b = a - base;
  return base + b * cosh(turn) + sqrt(b * b + wfvArcDelta * wfvArcDelta) * sinh(turn);
}

// Newton's step on the squared distance of p, from the angle c; in turns of wfvStepped, and in
// pixels.
vec2 wfvNewtonTurn(vec2 p, float c, float ref)
{
  float h = WFV_LINE_DIFFERENCE * wfvPixelAngle();
  vec2 before = wfvArcPixel(wfvStepped(c, -h), ref);
  vec2 here = wfvArcPixel(c, ref);
  vec2 behind = wfvArcPixel(wfvStepped(c, h), ref);
  vec2 slope = (behind - before) / (2.0 * h);
  vec2 curvature = (behind - 2.0 * here + before) / (h * h);
  vec2 r = wfvAcrossSeam(p - here);
  float speed = dot(slope, slope);
  float m = max(speed - dot(r, curvature), WFV_LINE_DAMPING * speed);
  float turn = m > 0.0 ? dot(r, slope) / m : 0.0;
  turn = clamp(turn, -WFV_LINE_LONGEST_STEP, WFV_LINE_LONGEST_STEP);
  return vec2(turn, abs(turn) * sqrt(speed));
}

// Takes the place at the angle a for the nearest one if it is; its distance from p.
float wfvTry(vec2 p, float a, float ref)
{
  vec2 r = wfvAcrossSeam(p - wfvArcPixel(a, ref));
  float d = length(r);
  if (d < wfvBestDistance)
  {
    wfvBestDistance = d;
    wfvBestOffset = r;
    wfvBestAngle = a;
  }
  return d;
}

// Newton's method from a start, which it leaves at the result; a step that leads away is
// halved. Lines that are their chords take no step: software renderers run both sides of a
// branch for every pixel, but leave a loop when none needs it, unless it is unrolled.
void wfvRefine(vec2 p, int which, int most)
{
  int steps = wfvLineKind == 0 ? -1 : most;
  WfvStart s = wfvStarts[which];
  float h = WFV_LINE_DIFFERENCE * wfvPixelAngle();
  float nearest = 1e9;
  float a = s.a;
  for (int i = 0; i <= steps; i++)
  {
    float d = wfvTry(p, s.a, s.ref);
    if (d >= nearest)
    {
      s.a = 0.5 * (a + s.a);
      continue;
    }
    nearest = d;
    a = s.a;
    // no slopes across a jump
    float c = s.lo == wfvArcCut ? max(a, wfvStepped(s.lo, h)) : a;
    c = s.hi == wfvBeforeCut ? min(c, wfvStepped(s.hi, -h)) : c;
#if WFV_NON_CENTRAL
    c = s.lo == wfvArcGap.y ? max(a, wfvStepped(s.lo, h)) : c;
    c = s.hi == wfvArcGap.x ? min(c, wfvStepped(s.hi, -h)) : c;
#endif
    vec2 turn = wfvNewtonTurn(p, c, s.ref);
    s.a = clamp(wfvStepped(c, turn.x), s.lo, s.hi);
    steps = turn.y < WFV_LINE_STEP ? min(steps, i + 1) : steps;
  }
  wfvStarts[which].a = a;
}

float wfvScanned[2]; // distances of the starts from their chords

// Puts the two nearest chords between knots, not side by side, into the starts.
void wfvScan(vec2 p, float lo, float hi, float ref)
{
  float a = lo;
  vec2 from = wfvArcPixel(lo, ref);
  int last = -2;
  // see wfvRefine
  int knots = wfvLineKind == 2 ? 4 * WFV_KNOTS : 0;
  for (int i = 1; i <= knots; i++)
  {
    float b = i == 4 * WFV_KNOTS ? hi : clamp(wfvKnot(i), lo, hi);
    if (!(b > a))
    {
      continue;
    }
    vec2 to = wfvArcPixel(b, ref);
    vec2 r = wfvAcrossSeam(p - 0.5 * (from + to)) + 0.5 * (to - from);
    float t = wfvOnChord(r, to - from);
    float d = length(r - t * (to - from));
    WfvStart s = WfvStart(mix(a, b, t), lo, hi, ref);
    if (d < wfvScanned[0])
    {
      bool beside = last == i - 1;
      wfvStarts[1] = beside ? wfvStarts[1] : wfvStarts[0];
      wfvScanned[1] = beside ? wfvScanned[1] : wfvScanned[0];
      wfvStarts[0] = s;
      wfvScanned[0] = d;
      last = i;
    }
    else if (d < wfvScanned[1] && last != i - 1)
    {
      wfvStarts[1] = s;
      wfvScanned[1] = d;
    }
    a = b;
    from = to;
  }
}

#if WFV_NON_CENTRAL
// The starts between two angles, which a cut may part.
void wfvScanParts(vec2 p, float lo, float hi)
{
  if (wfvArcCut > lo && wfvArcCut < hi)
  {
    wfvScan(p, lo, wfvBeforeCut, wfvArcRef(lo, wfvArcCut));
    lo = wfvArcCut;
  }
  wfvScan(p, lo, hi, wfvArcRef(lo, hi));
}

// The starts on either side of a gap, or all along.
void wfvStartAnywhere(vec2 p)
{
  wfvScanned[0] = wfvScanned[1] = 1e9;
  wfvScanParts(p, wfvArcRange.x, min(wfvArcInner.x, wfvArcRange.y));
  if (wfvHasGap())
  {
    wfvScanParts(p, max(wfvArcInner.y, wfvArcRange.x), wfvArcRange.y);
  }
  wfvStartCount = wfvScanned[1] < 1e9 ? 2 : 1;
}
#else
// The starts for an arc of any kind.
void wfvStartAnywhere(vec2 p)
{
  wfvScanned[0] = wfvScanned[1] = 1e9;
  float lo = wfvArcRange.x;
  float hi = wfvArcRange.y;
  if (wfvArcCut < WFV_NO_CUT)
  {
    wfvScan(p, lo, wfvBeforeCut, wfvArcRef(lo, wfvArcCut));
    lo = wfvArcCut;
  }
  wfvScan(p, lo, hi, wfvArcRef(lo, hi));
  wfvStartCount = wfvScanned[1] < 1e9 ? 2 : 1;
}
#endif

void wfvStartDots()
{
  for (int i = 0; i < 2; i++)
  {
    float a = wfvLineEnds[i];
    wfvStarts[i] = WfvStart(a, a, a, wfvArcRef(a, a));
  }
  wfvStartCount = 2;
}

void wfvStartOnChord(vec2 p)
{
  wfvChordDistance(p);
  float lo = wfvArcRange.x;
  float hi = wfvArcRange.y;
  wfvStarts[0] = WfvStart(wfvBestAngle, lo, hi, wfvArcRef(lo, hi));
  wfvStartCount = 1;
}

// Chords from which the nearest point of what a face of a cube shows is looked for.
const int WFV_FACE_CHORDS = 4;

// The start on a face, where one chord is not enough.
void wfvStartOnFace(vec2 p)
{
  float lo = wfvArcRange.x;
  float hi = wfvArcRange.y;
  float nearest = 1e9;
  vec2 from = wfvArcPixel(lo, 0.0);
  for (int i = 0; i < WFV_FACE_CHORDS; i++)
  {
    vec2 to = wfvArcPixel(mix(lo, hi, float(i + 1) / float(WFV_FACE_CHORDS)), 0.0);
    float t = wfvOnChord(p - from, to - from);
    float d = length(p - mix(from, to, t));
    if (d < nearest)
    {
      nearest = d;
      wfvStarts[0] = WfvStart(mix(lo, hi, (float(i) + t) / float(WFV_FACE_CHORDS)), lo, hi, 0.0);
    }
    from = to;
  }
  wfvStartCount = lo <= hi ? 1 : 0;
}

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
