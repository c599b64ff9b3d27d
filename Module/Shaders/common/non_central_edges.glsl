// SPDX-License-Identifier: BSD-3-Clause
// Pre-clip of triangles where each ray of an eye begins at a place of its own: how far their edges are
// from their chords in the picture, and whether they reach its seam (continues non_central.glsl).

// Radii of the circle: an edge that passes its axis nearer than so many has no chord, unless it is
// short beside that distance and farther than the fewer.
const float WFV_NC_NEAR = 16.0;
const float WFV_NC_NEAREST = 1.5;

// Edges: what is short.
const float WFV_NC_EDGES = 4.0;

// Cosine of the angle that an edge with a chord is seen under at the most.
const float WFV_NC_SHORT = 0.5;

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
