// SPDX-License-Identifier: BSD-3-Clause
// Fragment side of lines: what the picture of a line is.
//
// A sample is inside where its distance in the map, in pixels, from the image of the
// line's great-circle arc is at most half the width; across a straight seam the distance
// is taken the short way round. So every end is a round cap of that radius, joints of
// polylines have no notches, and the strip shows on both sides of a seam. Where the arc
// runs through a pole its image jumps: each side has its own cap. Outside the domain of
// the map nothing is drawn. On the faces of a cube each shows the strip as its own map would
// if it went on beyond the face; a map that ends at a flat rim, where nothing behind it has a
// place, shows the arc up to there.
//
// Depth and attributes are those of the nearest point, mixed between the two ends as
// space does; where that point lies outside the clip spheres nothing is drawn. A line
// that points at the eye is a dot, shown at its nearest visible point; one through the
// eye is two.

flat in vec3 wfvLineTop;
flat in vec3 wfvLineSide;
flat in vec4 wfvLineEnds;
flat in vec4 wfvLineMap;
flat in int wfvLineMode;
#if WFV_FACES || WFV_FLAT_RIM || WFV_NON_CENTRAL
flat in vec2 wfvLineRange;
#endif

int wfvLineKind = 0; // of wfvLineMode, the mode alone
float wfvAlong = 0.0; // parameter of the nearest point, from the first end to the second
float wfvDepth = 0.0; // window depth there, 0 to 1
bool wfvHide = false; // not covered: discarded once the stock shader has run
const bool wfvFront = true; // as lines are

void wfvInterpolate(); // generated: sets the stock shader's inputs from wfvAlong

// Where a sample lies inside a pixel, from its centre, pixels; one sample: the centre.
uniform int wfvSamples;
uniform vec2 wfvSampleOffsets[WFV_MOST_SAMPLES];

// Pixels by which all samples are moved where their distance is measured: lines along the
// borders between pixels, which a graticule is full of, then fall on one side of them
// whatever the rounding.
const vec2 WFV_LINE_TIE = vec2(0.007, 0.011);

// Pixels: more than a sample lies from its pixel's centre.
const float WFV_LINE_SAMPLE = 0.8;

// The nearest point found so far.
float wfvBestAngle = 0.0;
float wfvBestDistance = 0.0;
vec2 wfvBestOffset = vec2(0.0); // from it, pixels

// Parameter, 0 to 1, of the point of a chord nearest to p, both from its first end.
float wfvOnChord(vec2 p, vec2 chord)
{
  float l2 = dot(chord, chord);
  return l2 > 0.0 ? clamp(dot(p, chord) / l2, 0.0, 1.0) : 0.0;
}

// Distance of p from the chord that stands for the arc; the angle of the nearest point is
// that of the direction seen there.
float wfvChordDistance(vec2 p)
{
  vec2 chord = wfvLineMap.zw - wfvLineMap.xy;
  vec2 r = wfvAcrossSeam(p - 0.5 * (wfvLineMap.xy + wfvLineMap.zw)) + 0.5 * chord;
  float t = wfvOnChord(r, chord);
  vec2 ndc = wfvLineMap.xy + t * chord - wfvTilePixel(vec2(0.0));
  ndc = wfvAcrossSeam(ndc) * 2.0 / (wfvViewport.zw * wfvTile.xy);
#if WFV_FACES
  vec3 d = wfvFaceDirection(wfvOnFace(ndc / wfvView.scale, wfvArcFace), wfvArcFace);
#else
  vec3 d = wfvUnproject(ndc, wfvView).direction;
#endif
#if WFV_NON_CENTRAL
  float a = wfvAngleOf(d);
#else
  float a = wfvAtan2(dot(d, wfvArcSide), dot(d, wfvArcTop));
#endif
  a = wfvNearestTurn(a, 0.5 * (wfvArcRange.x + wfvArcRange.y));
  wfvBestAngle = clamp(a, wfvArcRange.x, wfvArcRange.y);
  wfvBestOffset = r - t * chord;
  return length(wfvBestOffset);
}

// line_nearest.glsl
float wfvFindNearest(vec2 p);
float wfvSampleDistance(vec2 p);

// True where the strip holds a sample so far from it.
bool wfvInside(float d)
{
  vec2 away = d > 0.0 ? wfvBestOffset / d : vec2(0.0);
  return d + dot(away, WFV_LINE_TIE) <= 0.5 * wfvLineWidth;
}

// The face that shows a place so many pixels from the centre of the tile; 0 in other maps.
int wfvShownFace(vec2 p)
{
#if WFV_FACES
  vec2 ndc = 2.0 * p / wfvViewport.zw;
  return wfvFaceAt((ndc - wfvTile.zw) / wfvTile.xy / wfvView.scale);
#else
  return 0;
#endif
}

// True where the face drawn here shows that place.
bool wfvOwns(vec2 p)
{
#if WFV_FACES
  return wfvShownFace(p) == wfvArcFace;
#else
  return true;
#endif
}

// Coverage of the pixel, or of each of its samples, by the strip.
bool wfvCoverage(vec2 p, float d)
{
  float half_ = 0.5 * wfvLineWidth;
  if (wfvSamples <= 1)
  {
    return wfvInside(d) && wfvOwns(p);
  }
  int mask = wfvInside(d) ? -1 : 0;
  bool whole = wfvOwns(p - 0.5) && wfvOwns(p + 0.5);
  if (abs(d - half_) < WFV_LINE_SAMPLE || !whole)
  {
    mask = 0;
    for (int i = 0; i < wfvSamples; i++)
    {
      vec2 at = p + wfvSampleOffsets[i];
      mask |= wfvOwns(at) && wfvInside(wfvSampleDistance(at)) ? 1 << i : 0;
    }
  }
#ifdef GL_ARB_sample_shading
  gl_SampleMask[0] = mask;
#endif
  return mask != 0;
}

// Parameter of the point of the line that is seen at the angle a.
float wfvLineParameter(float a)
{
  vec4 e = wfvLineEnds;
  if (e.y - e.x <= 0.0)
  {
    // it points at the eye: its nearest end, or where it enters the near sphere
    float near = (1.0 + 1e-6) * wfvView.radii.x / wfvScale();
    float t = e.z < e.w ? 0.0 : 1.0;
    return min(e.z, e.w) < near && max(e.z, e.w) > near ? (near - e.z) / (e.w - e.z) : t;
  }
  float first = sin(max(a - e.x, 0.0)) * e.z;
  float second = sin(max(e.y - a, 0.0)) * e.w;
  return a <= e.x ? 0.0 : (a >= e.y ? 1.0 : first / (first + second));
}

void wfvUnpack(vec2 p)
{
  wfvArcTop = wfvLineTop;
  wfvArcSide = wfvLineSide;
  wfvArcEnds = wfvLineEnds;
#if WFV_FACES || WFV_FLAT_RIM || WFV_NON_CENTRAL
  wfvArcRange = wfvLineRange;
#else
  wfvArcRange = wfvLineEnds.xy;
#endif
#if WFV_FACES
  wfvArcFace = wfvLineMode / WFV_FACE_UNIT;
  wfvLineKind = wfvLineMode - WFV_FACE_UNIT * wfvArcFace;
  if (wfvLineKind == 5)
  {
#if WFV_NON_CENTRAL
    wfvUnpackNc(wfvLineMap, false);
    wfvArcFace = wfvShownFace(p);
    wfvKeepShown();
#else
    wfvKeepFace(wfvShownFace(p));
#endif
  }
#else
  wfvLineKind = wfvLineMode;
#endif
  bool parts = wfvLineKind == 2 || wfvLineKind == 3;
  wfvArcCut = parts ? wfvLineMap.x : WFV_NO_CUT;
  wfvArcDelta = parts ? abs(wfvLineMap.y) : 1.0;
  wfvArcJump = parts && wfvLineMap.y < 0.0;
#if WFV_NON_CENTRAL
  wfvUnpackNc(wfvLineMap, parts);
  wfvSetKnots();
#endif
}

void wfvPrepare()
{
#ifdef GL_ARB_sample_shading
  gl_SampleMask[0] = -1;
#endif
  vec2 p = gl_FragCoord.xy - wfvViewport.xy - 0.5 * wfvViewport.zw;
  wfvUnpack(p);
  bool inside = wfvUnproject(wfvNdcOfPixel(gl_FragCoord.xy), wfvView).inside;
  float d = wfvFindNearest(p);
  wfvAlong = wfvLineParameter(wfvBestAngle);
#if WFV_NON_CENTRAL
  wfvSeeLine(wfvAlong);
  float rho = wfvLineHitDistance;
#else
  vec3 at = mix(wfvLineEnds.z * wfvArcAt(wfvLineEnds.x), wfvLineEnds.w * wfvArcAt(wfvLineEnds.y),
    wfvAlong);
  float rho = length(at) * wfvScale();
#endif
  wfvDepth = wfvDepthOf(rho, wfvView);
  wfvInterpolate();
  // a pixel that the other part of a line draws has no sample inside
  inside = inside && d < 1e8 && wfvCoverage(p, d);
  wfvHide = !inside || !(wfvDepth >= 0.0 && wfvDepth <= 1.0);
}
