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
