// SPDX-License-Identifier: BSD-3-Clause
// Lines, what both stages share: the arc of a great circle that a line is seen as, and
// its image in the map.
//
// The arc is the directions cos(a) top + sin(a) side, a between two angles: the frame of
// its plane. For an arc that comes near a pole or the antipode `top` is the point of its
// great circle nearest to the axis, so that float32 resolves angles best where the map
// stretches most; otherwise it is the middle of the arc.

uniform float wfvLineWidth; // pixels

vec3 wfvArcTop = vec3(0.0);
vec3 wfvArcSide = vec3(0.0);
vec4 wfvArcEnds = vec4(0.0); // angles of the two ends, a0 <= a1, and their distances from the eye
vec2 wfvArcRange = vec2(0.0); // of these angles, those that the map shows
float wfvArcDelta = 0.0; // scale of the angles at which the image curves, radians
float wfvArcCut = 0.0; // angle at which the image jumps, or WFV_NO_CUT
#if WFV_FACES
int wfvArcFace = 0; // the face of the cube whose map this is
#endif
bool wfvArcJump = false; // it jumps because the arc runs through a pole: azimuths stay constant

const float WFV_NO_CUT = 1e9;

// Knots a quarter of a great circle, four quarters.
const int WFV_KNOTS = 14;

// The scale of the curves counts at least so much: the sine of WFV_AT_POLE.
const float WFV_LEAST_DELTA = 1e-6;

#if WFV_NON_CENTRAL
vec3 wfvArcAt(float a); // line_noncentral.glsl
#else
vec3 wfvArcAt(float a)
{
  return cos(a) * wfvArcTop + sin(a) * wfvArcSide;
}
#endif

// The angle so many turns away that is nearest to `ref`.
float wfvNearestTurn(float angle, float ref)
{
  return angle - 2.0 * WFV_PI * floor((angle - ref) / (2.0 * WFV_PI) + 0.5);
}

// Keeps, of the angles that the map shows, those where cos(a) atTop + sin(a) atSide is not
// negative: half a turn of them. None: the first is larger than the last.
void wfvKeepHalf(float atTop, float atSide)
{
  float middle = wfvAtan2(atSide, atTop);
  middle = wfvNearestTurn(middle, 0.5 * (wfvArcRange.x + wfvArcRange.y));
  wfvArcRange = vec2(max(wfvArcRange.x, middle - 0.5 * WFV_PI),
    min(wfvArcRange.y, middle + 0.5 * WFV_PI));
}

// Angles of a direction; the azimuth continued from `ref`, which it is where the arc runs
// through the pole.
vec2 wfvArcAngles(vec3 d, float ref)
{
  vec2 angles = WFV_ANGLES(d);
  return vec2(wfvArcJump ? ref : wfvNearestTurn(angles.x, ref), angles.y);
}

// Pixels from the centre of the tile, of a place in the map.
vec2 wfvTilePixel(vec2 ndc)
{
  return 0.5 * wfvViewport.zw * (ndc * wfvTile.xy + wfvTile.zw);
}

// Image of the arc at the angle a, pixels from the centre of the tile.
vec2 wfvArcPixel(float a, float ref)
{
  vec3 d = wfvArcAt(a);
#if WFV_FACES
  return wfvTilePixel(wfvProjectOnFace(d, wfvArcFace, wfvView));
#elif WFV_MERIDIAN
  return wfvTilePixel(wfvMap(wfvArcAngles(d, ref), wfvView));
#else
  return wfvTilePixel(wfvArcJump ? wfvMap(wfvArcAngles(d, ref), wfvView) : wfvProject(d, wfvView));
#endif
}

// Radians: a stretch whose middle is so near the seam counts as on it.
const float WFV_ON_SEAM = 2e-6;

// The azimuth that a stretch of the arc is continued from: that of its middle. On the seam
// the sign is noise: longitudes end at +pi.
float wfvArcRef(float lo, float hi)
{
  float azimuth = WFV_ANGLES(wfvArcAt(0.5 * (lo + hi))).x;
  return azimuth < -WFV_PI + WFV_ON_SEAM ? WFV_PI : azimuth;
}

// Pixels from border to border of a map that closes across a straight seam, or 0.
float wfvPeriod()
{
#if WFV_MERIDIAN && WFV_STRAIGHT_SEAM
  return wfvViewport.z * wfvTile.x * wfvMap(vec2(WFV_PI, 0.0), wfvView).x;
#else
  return 0.0;
#endif
}

// From one place of the picture to another, the short way round.
vec2 wfvAcrossSeam(vec2 d)
{
#if WFV_MERIDIAN && WFV_STRAIGHT_SEAM
  float period = wfvPeriod();
  d.x -= period * floor(d.x / period + 0.5);
#endif
  return d;
}

#if !WFV_NON_CENTRAL
// Angle of knot i, 0 to 4 WFV_KNOTS, from half a turn before top to half a turn behind it.
// They are dense where the image may curve: near top, and opposite to it; or, where a map is
// flat at its rim, which arcs meet a quarter of a turn from top, there.
float wfvKnot(int i)
{
  int k = i <= WFV_KNOTS ? i
                         : (i <= 3 * WFV_KNOTS ? abs(i - 2 * WFV_KNOTS) : 4 * WFV_KNOTS - i);
  float x = 0.5 * WFV_PI / wfvArcDelta;
  float step_ = log(x + sqrt(x * x + 1.0)) / float(WFV_KNOTS);
  float e = exp(step_ * float(k));
  float g = k == WFV_KNOTS ? 0.5 * WFV_PI : 0.5 * wfvArcDelta * (e - 1.0 / e);
#if WFV_FLAT_RIM
  float rest = 1.0 - float(k) / float(WFV_KNOTS);
  g = 0.5 * WFV_PI * (1.0 - rest * rest);
#endif
  float turned = i < 2 * WFV_KNOTS ? -1.0 : 1.0;
  bool far = i < WFV_KNOTS || i > 3 * WFV_KNOTS;
  return turned * (far ? WFV_PI - g : g);
}
#endif

// Angle a pixel takes up in the middle of the map, radians.
float wfvPixelAngle()
{
#if WFV_MERIDIAN
  return 2.0 * wfvView.halfFov.y / (wfvViewport.w * wfvTile.y);
#else
  return 2.0 * wfvView.halfFov.x / (wfvViewport.z * wfvTile.x);
#endif
}

#if WFV_FACES
// wfvLineMode: the mode and, in this unit, the face.
const int WFV_FACE_UNIT = 8;

// Pixels round a face within which the line still counts, beside half its width: cuts and
// rounding.
const float WFV_FACE_PAD = 2.0;

// Radians: the map of a face is carried on no farther.
const float WFV_FACE_BEYOND = 0.6;

#if WFV_NON_CENTRAL
// Tangent of the angle from the middle of a face as far as which its map is carried on.
float wfvFaceTangent()
{
  vec2 pixel = 0.5 * WFV_PI * vec2(3.0, 2.0) / (wfvViewport.zw * wfvTile.xy);
  float more = (0.5 * wfvLineWidth + WFV_FACE_PAD) * max(pixel.x, pixel.y);
  float angle = 0.25 * WFV_PI + min(more, WFV_FACE_BEYOND);
  return sin(angle) / cos(angle);
}
#else
// Leaves, of the arc, what a face shows with its map carried on beyond its borders by as much
// as the strip is wide: it is continued there as it is on the face.
void wfvKeepFace(int face)
{
  wfvArcFace = face;
  wfvArcRange = wfvArcEnds.xy;
  vec2 pixel = 0.5 * WFV_PI * vec2(3.0, 2.0) / (wfvViewport.zw * wfvTile.xy);
  float more = (0.5 * wfvLineWidth + WFV_FACE_PAD) * max(pixel.x, pixel.y);
  float angle = 0.25 * WFV_PI + min(more, WFV_FACE_BEYOND);
  float t = sin(angle) / cos(angle);
  vec3 top = wfvInFace(wfvArcTop, face);
  vec3 side = wfvInFace(wfvArcSide, face);
  wfvKeepHalf(t * top.z - top.x, t * side.z - side.x);
  wfvKeepHalf(t * top.z + top.x, t * side.z + side.x);
  wfvKeepHalf(t * top.z - top.y, t * side.z - side.y);
  wfvKeepHalf(t * top.z + top.y, t * side.z + side.y);
}
#endif
#endif
