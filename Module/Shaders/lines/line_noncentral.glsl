// SPDX-License-Identifier: BSD-3-Clause
// Lines, what both stages share where each ray of an eye begins at a place of its own, on a circle
// round the origin (StereoTraits::OneCenter): the image of a line is that of the directions in
// which its points are seen, which is no great circle.
//
// A point of the line is known by its angle a, as on an arc seen from the origin:
//   (cos(a) top + sin(a) side) distance / cos(a - foot)
// where `foot` is the angle of the line's point nearest to the origin. The distance is not that of
// this point but about that of the line from the circle, so that also a line towards the origin
// has angles, which grow as those under which the eye sees it do. Lengths are in the stage's unit.

float wfvArcFoot = 0.0; // radians
float wfvArcDistance = 0.0; // above 0
vec2 wfvArcGap = vec2(0.0); // the angles between which no ray sees the line, or WFV_NO_CUT twice
vec2 wfvArcInner = vec2(0.0); // the same, or farther apart where the map does not show what is beside them

// Beyond this cosine of its angle from the foot a line goes on no farther.
const float WFV_NC_END = 1e-9;

// Two angles, on either side of 0, near which the image curves most, where top alone is not enough.
vec2 wfvArcTops = vec2(0.0);
bool wfvTwoTops = false;

bool wfvHasGap()
{
  return wfvArcGap.x < WFV_NO_CUT;
}

// Where the knots begin and end, in the turns of wfvFromTop; of two tops those of the second too.
vec4 wfvNcKnots = vec4(0.0);

vec3 wfvNcAhead(float a)
{
  return cos(a) * wfvArcTop + sin(a) * wfvArcSide;
}

// Of the line: its point at the top or, where that is very far, its foot; its direction; and what
// makes the squared horizontal distance to the circle of the way s from there: x + s (y + s z). Beside a gap
// that is z times the product of the ways from its ends, for the azimuth turns as the root of them.
vec3 wfvNcBegin = vec3(0.0);
vec3 wfvNcAlong = vec3(0.0);
vec3 wfvNcWay = vec3(0.0);
float wfvNcScale = 0.0; // one over the cosine of the angle between the two; 0: the foot

// The least such cosine of which float32 leaves enough.
const float WFV_NC_FAR = 0.01;

// Part of the circle's radius that the horizontal distance is at the least: at the end of a gap there is an
// azimuth.
const float WFV_NC_WAY = 1e-7;

// Squared horizontal distance from the point at the angle a, which is so far from wfvNcBegin.
float wfvNcWayOf(float a, float s, float far)
{
  if (wfvHasGap())
  {
    vec2 ways = wfvArcDistance * far * sin(vec2(a) - wfvArcGap) / max(cos(wfvArcGap - wfvArcFoot), WFV_NC_END);
    return wfvNcWay.z * ways.x * ways.y;
  }
  return wfvNcWay.x + s * (wfvNcWay.y + s * wfvNcWay.z);
}

// What the eye sees of the point at the angle a; lengths are in the stage's unit.
WfvRayHit wfvNcHit(float a)
{
  float far = 1.0 / max(cos(a - wfvArcFoot), WFV_NC_END);
  if (wfvFades(wfvView))
  {
    WfvRayHit hit = wfvSee(wfvNcAhead(a) * (wfvArcDistance * far * wfvScale()), wfvView);
    hit.distance /= wfvScale();
    return hit;
  }
  float s = wfvArcDistance * far * (wfvNcScale > 0.0 ? sin(a) * wfvNcScale : sin(a - wfvArcFoot));
  vec3 up = wfvUpright(wfvView);
  vec3 p = wfvNcBegin + s * wfvNcAlong;
  float y = dot(p, up);
  float r = wfvToRight(wfvView) / wfvScale();
  float way = sqrt(max(wfvNcWayOf(a, s, far), 0.0));
  return wfvSeeAt(p - up * y, y, max(way, WFV_NC_WAY * abs(r)), up, r);
}

vec3 wfvArcAt(float a)
{
  return wfvNcHit(a).direction;
}

// Behind every change of the frame or the range.
void wfvSetLine()
{
  float c = cos(wfvArcFoot);
  float s = sin(wfvArcFoot);
  vec3 up = wfvUpright(wfvView);
  wfvNcScale = c > WFV_NC_FAR ? 1.0 / c : 0.0;
  wfvNcAlong = c * wfvArcSide - s * wfvArcTop;
  vec3 begin = c > WFV_NC_FAR ? wfvArcTop / c : c * wfvArcTop + s * wfvArcSide;
  wfvNcBegin = wfvArcDistance * begin;
  vec3 level = wfvNcBegin - up * dot(wfvNcBegin, up);
  vec3 along = wfvNcAlong - up * dot(wfvNcAlong, up);
  float r = wfvFromMiddle(wfvView) / wfvScale();
  float l = length(level);
  wfvNcWay = vec3((l - r) * (l + r), 2.0 * dot(level, along), dot(along, along));
}

float wfvAsinh(float x)
{
  float s = abs(x);
  return sign(x) * log(s + sqrt(s * s + 1.0));
}

float wfvFromTop(float turns)
{
  return wfvArcDelta * sinh(turns);
}

// Before wfvKnot is asked for.
void wfvSetKnots()
{
  vec4 ends = vec4(wfvArcRange, 0.0, 0.0);
  ends = wfvHasGap() ? vec4(wfvArcRange - wfvArcGap, 0.0, 0.0) : ends;
  ends = wfvTwoTops ? vec4(wfvArcRange - wfvArcTops, -wfvArcTops) : ends;
  for (int i = 0; i < 4; i++)
  {
    wfvNcKnots[i] = wfvAsinh(ends[i] / wfvArcDelta);
  }
}

// Angle of knot i, 0 to 4 WFV_KNOTS, from one end of the range to the other. They are dense where
// the image may curve: near top, or both ends of a gap, or, where a map is flat at its rim, the ends.
float wfvKnot(int i)
{
  float share = float(i) / float(4 * WFV_KNOTS);
  if (wfvTwoTops)
  {
    return share <= 0.5
      ? wfvArcTops.x + wfvFromTop(mix(wfvNcKnots.x, wfvNcKnots.z, 2.0 * share))
      : wfvArcTops.y + wfvFromTop(mix(wfvNcKnots.w, wfvNcKnots.y, 2.0 * share - 1.0));
  }
  if (wfvHasGap())
  {
    return share <= 0.5 ? wfvArcGap.x + wfvFromTop(wfvNcKnots.x * (1.0 - 2.0 * share))
                        : wfvArcGap.y + wfvFromTop(wfvNcKnots.y * (2.0 * share - 1.0));
  }
#if WFV_FLAT_RIM
  return mix(wfvArcRange.x, wfvArcRange.y, 0.5 - 0.5 * cos(WFV_PI * share));
#else
  return wfvFromTop(mix(wfvNcKnots.x, wfvNcKnots.y, share));
#endif
}

#if WFV_FACES || WFV_FLAT_RIM
// Steps of a search by halves for float32, and of one by thirds; where the latter begins.
const int WFV_NC_HALVES = 26;
const int WFV_NC_THIRDS = 24;
const int WFV_NC_PLACES = 24;

// By how much the direction at the angle a is inside what the map, or the face, shows.
float wfvNcMargin(float a)
{
  vec3 d = wfvArcAt(a);
#if WFV_FACES
  vec3 q = wfvInFace(d, wfvArcFace);
  return wfvFaceTangent() * q.z - max(abs(q.x), abs(q.y));
#else
  return -d.z;
#endif
}

float wfvNcMiddle()
{
  float best = -1e9;
  float at = wfvArcRange.x;
  float step_ = (wfvArcRange.y - wfvArcRange.x) / float(WFV_NC_PLACES);
  for (int i = 0; i <= WFV_NC_PLACES; i++)
  {
    float a = wfvArcRange.x + float(i) * step_;
    float m = wfvNcMargin(a);
    at = m > best ? a : at;
    best = max(best, m);
  }
  vec2 ends = clamp(vec2(at - step_, at + step_), wfvArcRange.x, wfvArcRange.y);
  for (int i = 0; i < WFV_NC_THIRDS; i++)
  {
    vec2 inner = mix(ends.xx, ends.yy, vec2(1.0, 2.0) / 3.0);
    ends = wfvNcMargin(inner.x) > wfvNcMargin(inner.y) ? vec2(ends.x, inner.y)
                                                         : vec2(inner.x, ends.y);
  }
  return 0.5 * (ends.x + ends.y);
}

// The angle between inside and outside at which the one becomes the other.
float wfvNcBorder(float inside, float outside)
{
  for (int i = 0; i < WFV_NC_HALVES; i++)
  {
    float a = 0.5 * (inside + outside);
    bool in_ = wfvNcMargin(a) >= 0.0;
    inside = in_ ? a : inside;
    outside = in_ ? outside : a;
  }
  return inside;
}

// Leaves, of the range of angles, what the map or the face shows: what is inside is in one piece.
void wfvKeepShown()
{
  float middle = wfvNcMiddle();
  vec2 range = wfvArcRange;
  bool none = !(wfvNcMargin(middle) >= 0.0);
  wfvArcRange.x = wfvNcMargin(range.x) >= 0.0 ? range.x : wfvNcBorder(middle, range.x);
  wfvArcRange.y = wfvNcMargin(range.y) >= 0.0 ? range.y : wfvNcBorder(middle, range.y);
  wfvArcRange = none ? vec2(1.0, -1.0) : wfvArcRange;
}
#endif
