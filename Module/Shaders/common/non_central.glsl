// SPDX-License-Identifier: BSD-3-Clause
// Pre-clip of triangles where each ray of an eye begins at a place of its own, on a circle round
// the origin (StereoTraits::OneCenter). Planes and bounds are those of the view from the
// origin; the fragment stage adds what the ray's beginning changes, exactly. What is here makes
// the shapes large enough: seen from anywhere on the circle, nothing is farther than wfvGrow
// from where the origin sees it.

float wfvGrow = 0.0; // radians; half a turn where the triangle is as near as the circle

// Radius of the circle in the stage's own units, the largest of all rays.
float wfvNcRadius()
{
  return wfvFromMiddle(wfvView) / wfvScale();
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
