// SPDX-License-Identifier: BSD-3-Clause
// Pre-clip, shared by triangles and lines: where a primitive meets the seam, and
// where a chord in the map is too far from the great circle it stands for.
//
// Points are in tilted view coordinates, divided by a power of two near the far radius
// (which costs no rounding). Every decision about an edge is a symmetric function of
// its two end points, so that neighbours decide alike and no crack opens.

uniform float wfvTolerance; // pixels

// Safety over the three points at which the distance to the chord is sampled.
const float WFV_CURVE_SAFETY = 1.2;

// Beside shares of their chord no nearer to its ends than this are the quarters of an edge that is
// like an arc of a parabola, which stays between the ends; and they are no farther from the chord
// than its middle, by more than this factor.
const float WFV_EVEN_SHARE = 0.1;
const float WFV_EVEN_CURVATURE = 1.1;

// Pixels: of an edge that is nearer to its chord nothing else is asked.
const float WFV_NEAR_CHORD = 0.5;

// Round a pole or the antipode, inside so many pixels or WFV_SINGULAR_ANGLE, whichever is more, edges are
// never drawn as chords.
const float WFV_SINGULAR_PIXELS = 16.0;

// An edge that no chord may stand for.
const float WFV_CURVED = -1.0;

// Pixels: more than any picture has.
const float WFV_UNKNOWN = 1e9;

// Sine of the angle from a pole or the antipode inside which a point has no azimuth of
// its own: float32 cannot tell.
const float WFV_AT_POLE = 1e-6;

// True where p lies on the axis of the pole (either end).
bool wfvAtPole(vec3 p, vec3 pole)
{
  return length(cross(p, pole)) <= WFV_AT_POLE * length(p);
}

// Lexicographic order of two points: the canonical direction of an edge.
bool wfvOrdered(vec3 a, vec3 b)
{
  return a.x != b.x ? a.x < b.x : (a.y != b.y ? a.y < b.y : a.z < b.z);
}

float wfvWrap(float angle)
{
  return angle - 2.0 * WFV_PI * floor((angle + WFV_PI) / (2.0 * WFV_PI));
}

// Point where the edge a, b meets the plane x = 0; a.x and b.x differ in sign.
// Returns the parameter from a to b.
float wfvSeamParameter(vec3 a, vec3 b)
{
  return wfvOrdered(a, b) ? a.x / (a.x - b.x) : 1.0 - b.x / (b.x - a.x);
}

vec3 wfvSeamPoint(vec3 a, vec3 b)
{
  vec3 p = wfvOrdered(a, b) ? mix(a, b, a.x / (a.x - b.x)) : mix(b, a, b.x / (b.x - a.x));
  return vec3(0.0, p.y, p.z);
}

// Distance, in pixels, of p from the chord a, b.
float wfvChordDistance(vec2 a, vec2 b, vec2 p)
{
  vec2 half_ = 0.5 * wfvViewport.zw * wfvTile.xy;
  vec2 ab = (b - a) * half_;
  vec2 ap = (p - a) * half_;
  float l = length(ab);
  return l > 0.01 ? abs(ab.x * ap.y - ab.y * ap.x) / l : length(ap);
}

// Share of the chord a, b beside which p lies.
float wfvChordShare(vec2 a, vec2 b, vec2 p)
{
  vec2 half_ = 0.5 * wfvViewport.zw * wfvTile.xy;
  vec2 ab = (b - a) * half_;
  return dot((p - a) * half_, ab) / max(dot(ab, ab), 1e-12);
}

// Map of p, continued across the seam from the longitude of the point before it.
#if WFV_MERIDIAN && WFV_STRAIGHT_SEAM
vec2 wfvContinued(vec3 p, vec2 from)
{
  vec2 a = wfvMeridianAngles(p);
  return vec2(from.x + wfvWrap(a.x - from.x), a.y);
}
#endif

// Largest distance, in pixels, between the chord of a and b in the map and the places of an edge
// between them, in this order: p, m, q; WFV_UNKNOWN where these say little of what is between.
float wfvSampledError(vec3 a, vec3 p, vec3 m, vec3 q, vec3 b)
{
#if WFV_MERIDIAN && WFV_STRAIGHT_SEAM
  // longitudes are continued along the edge: the seam does not count as curvature
  vec2 ta = wfvMeridianAngles(a);
  vec2 tp = wfvContinued(p, ta);
  vec2 tm = wfvContinued(m, tp);
  vec2 tq = wfvContinued(q, tm);
  vec2 tb = wfvContinued(b, tq);
  vec2 na = wfvMap(ta, wfvView);
  vec2 np = wfvMap(tp, wfvView);
  vec2 nm = wfvMap(tm, wfvView);
  vec2 nq = wfvMap(tq, wfvView);
  vec2 nb = wfvMap(tb, wfvView);
#else
  vec2 na = wfvProject(a, wfvView);
  vec2 np = wfvProject(p, wfvView);
  vec2 nm = wfvProject(m, wfvView);
  vec2 nq = wfvProject(q, wfvView);
  vec2 nb = wfvProject(b, wfvView);
#endif
  float middle = wfvChordDistance(na, nb, nm);
  float quarters = max(wfvChordDistance(na, nb, np), wfvChordDistance(na, nb, nq));
  float e = max(middle, quarters);
  bool even = quarters <= WFV_EVEN_CURVATURE * middle &&
    min(wfvChordShare(na, nb, np), 1.0 - wfvChordShare(na, nb, nq)) >= WFV_EVEN_SHARE;
  return e > WFV_NEAR_CHORD && !even ? WFV_UNKNOWN : WFV_CURVE_SAFETY * e;
}

// The same of a great circle's arc.
float wfvEdgeError(vec3 a, vec3 b)
{
  vec3 m = normalize(a + b);
  return wfvSampledError(a, normalize(a + m), m, normalize(m + b), b);
}

// True where the arc a, b (unit vectors) comes within asin(s) of the axis.
bool wfvNears(vec3 a, vec3 b, vec3 axis, float s)
{
  float c = sqrt(1.0 - s * s);
  if (dot(a, axis) > c || dot(b, axis) > c)
  {
    return true;
  }
  vec3 n = cross(a, b);
  float l = length(n);
  if (!(abs(dot(n, axis)) < s * l))
  {
    return false;
  }
  vec3 top = axis - n * (dot(axis, n) / (l * l));
  return dot(cross(a, top), n) > 0.0 && dot(cross(top, b), n) > 0.0;
}

// Sine of the angle round a singular point of the map inside which no chord is drawn:
// there a pixel no longer looks like a plane.
float wfvSingularSine()
{
#if !WFV_ROUND
  float pixel = 2.0 * wfvView.halfFov.y / (wfvViewport.w * wfvTile.y);
#else
  float pixel = 2.0 * wfvView.halfFov.x / (wfvViewport.z * wfvTile.x);
#endif
  return sin(clamp(WFV_SINGULAR_PIXELS * pixel, WFV_SINGULAR_ANGLE, 1.0));
}

// True where the arc comes that near to a point that the map stretches without bound.
bool wfvNearsSingularity(vec3 a, vec3 b)
{
  float s = wfvSingularSine();
#if WFV_FACES || WFV_SAMPLED
  return false;
#elif WFV_MERIDIAN
  return wfvNears(a, b, vec3(0.0, 1.0, 0.0), s) || wfvNears(a, b, vec3(0.0, -1.0, 0.0), s);
#else
  return wfvNears(a, b, vec3(0.0, 0.0, 1.0), s);
#endif
}

#if WFV_ROUND
// Cosine of the angle from the axis beyond which no edge is drawn as a chord: behind the
// rim of a round map, whence chords would cut across it, and beside a rim where the map is
// flat and pixels are no measure of angles.
float wfvChordEnd()
{
#if WFV_FLAT_RIM
  vec2 pixels = 0.5 * wfvViewport.zw * wfvTile.xy * wfvView.scale;
  float strip = WFV_SINGULAR_PIXELS / min(pixels.x, pixels.y);
  return cos(wfvTheta(max(0.0, wfvRadius(0.5 * WFV_PI, wfvView) - strip), wfvView));
#else
  return wfvView.maxAngle < 0.4999 * WFV_PI ? -2.0 : cos(wfvView.maxAngle);
#endif
}
#endif

// The chord p, q in the map against its edge. x: by how many pixels they differ, or
// WFV_CURVED where that is more than the tolerance. y: a bound of the pixels,
// WFV_UNKNOWN near places where the map has none.
vec2 wfvChordError(vec3 p, vec3 q)
{
  vec3 a = wfvOrdered(p, q) ? p : q;
  vec3 b = wfvOrdered(p, q) ? q : p;
  vec3 da = normalize(a);
  vec3 db = normalize(b);
  float c = dot(da, db);
  bool unknown = !(c > -0.5) || wfvNearsSingularity(da, db);
#if WFV_MERIDIAN && !WFV_STRAIGHT_SEAM
  unknown = unknown ||
    (min(a.x, b.x) <= 0.0 && max(a.x, b.x) >= 0.0 && (a.z > 0.0 || b.z > 0.0));
#endif
#if WFV_FACES
  unknown = unknown || wfvFaceOf(da) != wfvFaceOf(db);
#elif WFV_ROUND
  unknown = unknown || -max(da.z, db.z) < wfvChordEnd();
#endif
  if (unknown)
  {
    return vec2(WFV_CURVED, WFV_UNKNOWN);
  }
  float error = wfvEdgeError(da, db);
  return vec2(error <= wfvTolerance ? error : WFV_CURVED, c > 0.5 ? error : WFV_UNKNOWN);
}

// Clip coordinates of a point of a polygon that lies on one side of the seam, or on the
// face of a cube numbered side - 1; 0: wherever it lies.
vec4 wfvClipOnSide(vec3 p, float side)
{
  float rho = wfvLength(p) * wfvScale();
#if WFV_FACES
  int face = side == 0.0 ? wfvFaceOf(p) : int(side) - 1;
  return wfvClip(wfvProjectOnFace(p, face, wfvView), rho);
#elif WFV_MERIDIAN
  vec2 angles = wfvMeridianAngles(p);
  float lambda = side == 0.0 ? angles.x : side * abs(angles.x);
  return wfvClip(wfvMap(vec2(lambda, angles.y), wfvView), rho);
#else
  return wfvClip(wfvProject(p, wfvView), rho);
#endif
}
