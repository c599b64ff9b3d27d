// SPDX-License-Identifier: BSD-3-Clause
// Pre-clip of triangles where each ray of an eye begins at a place of its own, on a circle round
// the origin (StereoTraits::OneCenter). Planes and bounds are those of the view from the
// origin; the fragment stage adds what the ray's beginning changes, exactly. What is here makes
// the shapes large enough: seen from anywhere on the circle, nothing is farther than wfvGrow
// from where the origin sees it.

// Radii of the circle: an edge that passes its axis nearer than so many has no chord, unless it is
// short beside that distance and farther than the fewer.
const float WFV_NC_NEAR = 16.0;
const float WFV_NC_NEAREST = 1.5;

// Edges: what is short.
const float WFV_NC_EDGES = 4.0;

// Cosine of the angle that an edge with a chord is seen under at the most.
const float WFV_NC_SHORT = 0.5;

float wfvGrow = 0.0; // radians; half a turn where the triangle is as near as the circle

// Radius of the circle in the stage's own units, the largest of all rays.
float wfvNcRadius()
{
  return wfvFromMiddle(wfvView) / wfvScale();
}

// Where the eye sees a point, as if it were the origin.
vec3 wfvSeenPlace(vec3 p)
{
  WfvRayHit s = wfvSee(p * wfvScale(), wfvView);
  return s.direction * (s.distance / wfvScale());
}

// True where the triangle has no plane. One that is seen edge-on from the origin may be seen from
// the circle.
bool wfvNcNothing()
{
  return !(max(abs(wfvT.x), max(abs(wfvT.y), abs(wfvT.z))) > 0.0);
}

// The distance of the triangle from the axis of the circle, at the most.
float wfvNcFarthest()
{
  vec3 up = wfvUpright(wfvView);
  return max(length(cross(wfvP[0], up)),
    max(length(cross(wfvP[1], up)), length(cross(wfvP[2], up))));
}

// True where all of the triangle is nearer to the axis than the circle: no ray passes there.
bool wfvNcUnseen()
{
  return !WFV_FADES && wfvNcFarthest() < 0.999 * abs(wfvToRight(wfvView)) / wfvScale();
}

// The triangle's least distance from the origin: that of its plane, or what its corners and
// edges leave. Sets wfvGrow.
void wfvSetGrow(vec3 lengths, vec4 plane)
{
  vec3 edges = vec3(length(wfvP[2] - wfvP[1]), length(wfvP[0] - wfvP[2]), length(wfvP[1] - wfvP[0]));
  float corners = min(lengths.x, min(lengths.y, lengths.z)) - max(edges.x, max(edges.y, edges.z));
  float nearest = max(corners, abs(plane.w) / length(plane.xyz));
  float s = 1.0001 * wfvNcRadius() / max(nearest, 1e-30);
  wfvGrow = s < 1.0 ? wfvAtan2(s, sqrt((1.0 - s) * (1.0 + s))) : WFV_PI;
}

// What the fragment stage needs to know of the edges beside their planes.
void wfvSetSpans(float facing)
{
  wfvSpans[0] = facing * (wfvP[2] - wfvP[1]);
  wfvSpans[1] = facing * (wfvP[0] - wfvP[2]);
  wfvSpans[2] = facing * (wfvP[1] - wfvP[0]);
}

// That, and wfvGrow.
void wfvSetNc(vec3 lengths, float facing)
{
  wfvSetSpans(facing);
  wfvSetGrow(lengths, wfvT);
}

// Radians of azimuth that a direction moves by at the most, when it moves by wfvGrow and is
// farther than that from the poles; half a turn where it is not. toPole: its angle from them.
float wfvGrowAzimuth(float toPole)
{
  float s = sin(min(wfvGrow, 0.5 * WFV_PI)) / max(sin(toPole), 1e-30);
  return toPole > wfvGrow && s < 1.0 ? wfvAtan2(s, sqrt((1.0 - s) * (1.0 + s))) : WFV_PI;
}

// A rectangle of angles, so much larger; all azimuths where it reaches a pole.
vec4 wfvGrowAngles(vec4 a, float toPole)
{
  float turn = wfvGrowAzimuth(toPole);
  return a + vec4(-turn, -wfvGrow, turn, wfvGrow);
}

// A range of latitudes, as seen from anywhere on the circle. Where the circle is level in the map, it
// sees everything nearer to a pole than the origin does, for the horizontal distance from there is shorter.
vec2 wfvNcLatitudes(vec2 a)
{
  bool level = !WFV_TILTED;
  return vec2(level && a.x > 0.0 ? a.x : a.x - wfvGrow, level && a.y < 0.0 ? a.y : a.y + wfvGrow);
}

// Square of the least distance of the edge a, b from the axis of the circle.
float wfvNcAxisSquared(vec3 a, vec3 b)
{
  vec3 up = wfvUpright(wfvView);
  vec3 p = a - up * dot(a, up);
  vec3 d = (b - up * dot(b, up)) - p;
  float t = clamp(-dot(p, d) / max(dot(d, d), 1e-30), 0.0, 1.0);
  vec3 nearest = p + t * d;
  return dot(nearest, nearest);
}

// Relative slack of distances from the axis of the circle.
const float WFV_NC_SLACK = 1e-4;

// Radians by which the azimuths turn between what is seen from the origin and by this eye, least and
// most, to either side; and the latitudes between which the eye sees the triangle.
vec2 wfvNcTurns = vec2(0.0);
vec2 wfvNcBand = vec2(0.0);

// The distance of the triangle from the axis of the circle, least and most. Not of one that the axis
// meets.
vec2 wfvNcLevels()
{
  float near = min(wfvNcAxisSquared(wfvP[0], wfvP[1]),
    min(wfvNcAxisSquared(wfvP[1], wfvP[2]), wfvNcAxisSquared(wfvP[2], wfvP[0])));
  return vec2(sqrt(near) * (1.0 - WFV_NC_SLACK), wfvNcFarthest() * (1.0 + WFV_NC_SLACK));
}

// Sets these two, of angles as seen from the origin, whose pole is the circle's axis where the map is
// not tilted: then a place at the distance d from the axis is turned by asin(r / d), away from where
// the eye is, and its horizontal distance from the circle is sqrt(d * d - r * r).
void wfvNcSet(vec4 a, bool pole)
{
  float turn = wfvGrowAzimuth(0.5 * WFV_PI - max(abs(a.y), abs(a.w)));
  wfvNcTurns = vec2(-turn, turn);
  wfvNcBand = wfvNcLatitudes(a.yw);
  float r = wfvNcRadius();
  vec2 levels = wfvNcLevels();
  if (WFV_TILTED || WFV_FADES || pole)
  {
    return;
  }
  // nothing is seen that is nearer to the axis than the circle
  vec2 ways = sqrt(max((levels - r) * (levels + r), 0.0));
  vec2 turns = vec2(wfvAtan2(r, ways.y), wfvAtan2(r, ways.x));
  wfvNcTurns = wfvToRight(wfvView) > 0.0 ? -turns.yx : turns;
  wfvNcTurns += vec2(-WFV_ANGLE_PAD, WFV_ANGLE_PAD);
  float low = min(wfvP[0].y, min(wfvP[1].y, wfvP[2].y));
  float high = max(wfvP[0].y, max(wfvP[1].y, wfvP[2].y));
  wfvNcBand = vec2(max(wfvNcBand.x, wfvAtan2(low, low < 0.0 ? ways.x : ways.y) - WFV_ANGLE_PAD),
    min(wfvNcBand.y, wfvAtan2(high, high < 0.0 ? ways.y : ways.x) + WFV_ANGLE_PAD));
}

// The easy bound (wfvEasy) of a triangle that is seen from the circle. How much farther than from
// the origin its corners may be from a singular point, radians, and how far its edges are off the
// great circles between them, times the way a place of the map moves: pixels at sine 1; y is endless where the triangle is as
// near to the circle as it is wide. longest: of edges, the square.
uniform float wfvStretch; // of the map at the most, weighed by the squared sine: NDC per radian

vec2 wfvNcEasy(vec3 lengths, float longest)
{
  vec3 up = wfvUpright(wfvView);
  vec3 heights = vec3(dot(wfvP[0], up), dot(wfvP[1], up), dot(wfvP[2], up));
  vec3 levels = (lengths - heights) * (lengths + heights); // squares of the level distances
  float r = wfvNcRadius();
  float way = min(levels.x, min(levels.y, levels.z)) - r * r; // square of the horizontal distance
  float nearest = min(lengths.x, min(lengths.y, lengths.z));
  bool far = way > 4.0 * r * r && way > 16.0 * longest;
  float deviation = r * longest / (way * sqrt((nearest - r) * (nearest + r)));
  float pixels = wfvStretch * length(0.5 * wfvViewport.zw * wfvTile.xy);
  return vec2(1.05 * r / nearest, far ? deviation * pixels : WFV_UNKNOWN);
}

// Angles from the circle over those from the origin, squared, at the most: beyond two radii.
const float WFV_NC_WIDER = 1.25;

#if WFV_MERIDIAN
// Of the angle that a triangle's longest edge has, seen from the axis of the circle: by no more do the
// places turn about the circle that its points are seen from, beyond WFV_NC_NEAREST radii.
const float WFV_NC_TURNING = 2.2;

// Relative to distances: what float32 rounds of a place.
const float WFV_NC_ROUNDING = 1e-5;

// True unless this eye sees nothing of the triangle across the seam: its points are seen from near the
// places that its corners are.
bool wfvNcSeesSeam()
{
  float r = 1.0001 * wfvNcRadius();
  vec3 up = wfvUpright(wfvView);
  float longest =
    max(length(wfvP[2] - wfvP[1]), max(length(wfvP[0] - wfvP[2]), length(wfvP[1] - wfvP[0])));
  float level = min(length(cross(wfvP[0], up)),
    min(length(cross(wfvP[1], up)), length(cross(wfvP[2], up)))) - longest;
  vec3 a = wfvSeenPlace(wfvP[0]);
  vec3 b = wfvSeenPlace(wfvP[1]);
  vec3 c = wfvSeenPlace(wfvP[2]);
  vec3 low = min(a, min(b, c));
  vec3 high = max(a, max(b, c));
  float aside = r * min(2.0, WFV_NC_TURNING * longest / max(level, 1e-30)) +
    WFV_NC_ROUNDING * max(wfvTaxiLength(low), wfvTaxiLength(high));
  bool far = level > WFV_NC_NEAREST * r;
  return !far || !(low.x > aside || high.x < -aside || high.z < -aside);
}
#endif

// True unless nothing of the triangle is seen across the seam, from anywhere on the circle.
bool wfvNcReachesSeam()
{
  float r = 1.0001 * wfvNcRadius();
  vec3 low = min(wfvP[0], min(wfvP[1], wfvP[2]));
  vec3 high = max(wfvP[0], max(wfvP[1], wfvP[2]));
#if WFV_FACES
  int face = wfvFaceOf(wfvP[0]);
  for (int i = 0; i < 3; i++)
  {
    vec3 q = wfvInFace(wfvP[i], face);
    if (!(q.z - max(abs(q.x), abs(q.y)) > 2.0 * r))
    {
      return true;
    }
  }
  return false;
#elif WFV_MERIDIAN
  bool near = !(low.x > r || high.x < -r || high.z < -r);
  for (int i = near && !WFV_FADES ? 1 : 0; i > 0; i--) // see wfvMustCover
  {
    near = wfvNcSeesSeam();
  }
  return near;
#else
  return false;
#endif
}

// The point of an edge whose direction is halfway between those of a and b.
vec3 wfvNcBetween(vec3 a, vec3 b)
{
  float l = length(a);
  float m = length(b);
  return (a * m + b * l) / (l + m);
}

// Largest sampled distance between the picture of an edge and its chord, pixels.
float wfvNcEdgeError(vec3 a, vec3 b)
{
  vec3 m = wfvNcBetween(a, b);
  return wfvSampledError(wfvSeenPlace(a), wfvSeenPlace(wfvNcBetween(a, m)), wfvSeenPlace(m),
    wfvSeenPlace(wfvNcBetween(m, b)), wfvSeenPlace(b));
}

// As wfvChordError, of an edge as this eye sees it: y alone is asked for.
vec2 wfvNcChordError(vec3 a, vec3 b)
{
  float r = wfvNcRadius();
  float axis = wfvNcAxisSquared(a, b);
  float edge = WFV_NC_EDGES * WFV_NC_EDGES * dot(b - a, b - a);
  if (!(axis > (axis > edge ? WFV_NC_NEAREST * WFV_NC_NEAREST : WFV_NC_NEAR * WFV_NC_NEAR) * r * r))
  {
    return vec2(WFV_CURVED, WFV_UNKNOWN);
  }
  vec3 da = normalize(wfvSeenPlace(a));
  vec3 db = normalize(wfvSeenPlace(b));
  bool unknown = !(dot(da, db) > WFV_NC_SHORT) || wfvNearsSingularity(da, db);
#if WFV_FACES
  unknown = unknown || wfvFaceOf(da) != wfvFaceOf(db);
#elif WFV_ROUND
  unknown = unknown || -max(da.z, db.z) < wfvChordEnd();
#endif
  return vec2(WFV_CURVED, unknown ? WFV_UNKNOWN : wfvNcEdgeError(a, b));
}
