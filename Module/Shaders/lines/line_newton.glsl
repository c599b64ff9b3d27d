// SPDX-License-Identifier: BSD-3-Clause
// Fragment side of lines, technique exact: Newton's method for the nearest point of an arc.

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
