// SPDX-License-Identifier: BSD-3-Clause
// Lines: shapes that surely contain the picture of each, for line_fragment.glsl, which
// says what the picture is. An arc that the map curves little gets one rectangle along its
// chord. Others are parted at the places where the map may curve or part them, and each
// part gets a rectangle of its own; which part a pixel belongs to is decided there.

layout(lines) in;
layout(triangle_strip, max_vertices = WFV_LINE_VERTICES) out;

flat out vec3 wfvLineTop;  // the frame of the arc and
flat out vec3 wfvLineSide;
flat out vec4 wfvLineEnds; // its ends, as in line_arc.glsl
flat out vec4 wfvLineMap;  // modes 0, 1: the chord, pixels; 2, 3: cut, sagitta, own range
flat out int wfvLineMode;  // 0 chord, 1 gently curved, 2 anything, 3 two dots; on a face: 4, 5
#if WFV_FACES || WFV_FLAT_RIM || WFV_NON_CENTRAL
flat out vec2 wfvLineRange; // the angles that the map, or this face, shows
#endif
#if WFV_NON_CENTRAL
flat out vec4 wfvLineFoot;  // foot, distance and gap of line_noncentral.glsl
#endif

// Pixels added round a shape: where parts share a line, half a pixel's diagonal and the
// rounding of the shape; where one holds it, the rounding alone.
const float WFV_LINE_PAD = 1.5;
const float WFV_LINE_THIN_PAD = 0.1;

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

vec4 wfvMapOut = vec4(0.0);
int wfvModeOut = 0;
int wfvQuadsLeft = 0;

// A rectangle in pixels of the tile, wound to be seen from its front.
void wfvEmitPixels(vec2 corner, vec2 right, vec2 up)
{
  if (wfvQuadsLeft <= 0)
  {
    return;
  }
  wfvQuadsLeft--;
  vec2 ndc = 2.0 / wfvViewport.zw;
  for (int i = 0; i < 4; i++)
  {
    vec2 p = corner + ((i & 1) != 0 ? right : vec2(0.0)) + ((i & 2) != 0 ? up : vec2(0.0));
    gl_Position = vec4(p * ndc, 0.0, 1.0);
    // flat outputs count at a strip's third and later vertices only
    if (i > 1)
    {
      wfvLineTop = wfvArcTop;
      wfvLineSide = wfvArcSide;
      wfvLineEnds = wfvArcEnds;
      wfvLineMap = wfvMapOut;
      wfvLineMode = wfvModeOut;
#if WFV_FACES
      wfvLineMode += WFV_FACE_UNIT * wfvArcFace;
#endif
#if WFV_FACES || WFV_FLAT_RIM || WFV_NON_CENTRAL
      wfvLineRange = wfvArcRange;
#endif
#if WFV_NON_CENTRAL
      wfvLineFoot = vec4(wfvArcFoot, wfvArcDistance, wfvArcGap);
#endif
      wfvWriteCorners();
      gl_PrimitiveID = gl_PrimitiveIDIn;
    }
    EmitVertex();
  }
  EndPrimitive();
}

// The same, and again on the other side where it reaches across a straight seam.
void wfvEmitRound(vec2 corner, vec2 right, vec2 up)
{
  wfvEmitPixels(corner, right, up);
  float period = wfvPeriod();
  if (period > 0.0)
  {
    float middle = wfvTilePixel(vec2(0.0)).x;
    float low = corner.x + min(right.x, 0.0) + min(up.x, 0.0) - middle;
    float high = corner.x + max(right.x, 0.0) + max(up.x, 0.0) - middle;
    if (low < -0.5 * period)
    {
      wfvEmitPixels(corner + vec2(period, 0.0), right, up);
    }
    if (high > 0.5 * period)
    {
      wfvEmitPixels(corner - vec2(period, 0.0), right, up);
    }
  }
}

// Pixels by which a shape is larger than the line's own middle.
float wfvLineGrow()
{
  return 0.5 * wfvLineWidth + (wfvModeOut < 2 ? WFV_LINE_THIN_PAD : WFV_LINE_PAD);
}

void wfvEmitAlong(vec2 from, vec2 to, float grow)
{
  // an end may be so far away that float32 counts in pixels: from the other one, no farther
  // than past the window
  bool first = dot(from, from) < dot(to, to);
  vec2 near = first ? from : to;
  vec2 chord = first ? to - from : from - to;
  float l = length(chord);
  vec2 along = l > 1e-3 ? chord / l : vec2(1.0, 0.0);
  vec2 across = vec2(-along.y, along.x);
  l = min(l, length(near) + wfvViewport.z + wfvViewport.w);
  wfvEmitRound(
    near - grow * (along + across), (l + 2.0 * grow) * along, 2.0 * grow * across);
}

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

#if WFV_NON_CENTRAL
// line_noncentral_geometry.glsl
bool wfvChordHolds(WfvStretch s, float lo, float hi);
void wfvEmitAngles(float lo, float hi, float ref);
#else
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
#endif

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

#if !WFV_NON_CENTRAL
void wfvEmitHard()
{
  wfvModeOut = 2;
  wfvFrameTop();
  wfvArcCut = wfvArcJump ? wfvArcCut : wfvSeamAngle();
  float a0 = wfvArcRange.x;
  float a1 = wfvArcRange.y;
  if (wfvArcCut < WFV_NO_CUT)
  {
    wfvEmitParts(a0, wfvArcCut, wfvArcRef(a0, wfvArcCut));
    a0 = wfvArcCut;
  }
  wfvEmitParts(a0, a1, wfvArcRef(a0, a1));
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

#if WFV_FACES
void wfvEmitOnFaces(bool dots); // line_on_faces.glsl
#elif WFV_SAMPLED
void wfvEmitOnDirections(bool dots); // line_on_directions.glsl
#else
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
#endif
#endif

void main()
{
  vec3 p = wfvTilt(gl_in[0].gl_Position.xyz, wfvView) / wfvScale();
  vec3 q = wfvTilt(gl_in[1].gl_Position.xyz, wfvView) / wfvScale();
  float longest = max(wfvLength(p), wfvLength(q));
  // inside the near sphere, or not a number, or where float32 ends
  if (!(longest * wfvScale() >= wfvView.radii.x) || !(longest < 1e18))
  {
    return;
  }
  wfvQuadsLeft = WFV_LINE_VERTICES / 4;
#if WFV_NON_CENTRAL
  wfvEmitNc(p, q);
#else
  wfvLevel = false;
  bool plane = wfvFrameArc(p, q);
  bool dots = !plane && wfvArcEnds.y > wfvArcEnds.x;
#if WFV_FACES
  wfvEmitOnFaces(dots);
#elif WFV_SAMPLED
  wfvEmitOnDirections(dots);
#else
  wfvEmitArc(dots);
#endif
#endif
}
