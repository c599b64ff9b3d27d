// SPDX-License-Identifier: BSD-3-Clause
// Fragment side of triangles of an eye whose rays are curves: what a pixel of its picture sees is a
// line of the cube of the map with its depth, and a curve of the scene. It meets the triangle's plane
// at a depth that is found by false position (Illinois), between the depths at which the triangle may
// be; with the ray of the map at that depth everything goes on as without stereo.

flat in vec2 wfvDepths; // NDC depths at which the triangle may be

// Parts of these depths: a sharp curve, or leaves the map, may meet the plane twice.
const int WFV_CURVE_PARTS = 8;

// Steps of the search in one of them: to float32's end at surfaces not seen edge-on.
const int WFV_CURVE_STEPS = 8;

// The depths of the curve that may meet the triangle, from t = 0 to 1.
vec2 wfvSpan = vec2(0.0);

#if WFV_ROUND
// A round map may turn without bound at its rim, where the span ends: steps in t are short at
// the ends, and their squares are even there.
float wfvDepthFrom(float t)
{
  return mix(wfvSpan.x, wfvSpan.y, t * t * (3.0 - 2.0 * t));
}

// Keeps of the triangle's depths those at which the curve is inside the map; false: none.
bool wfvSetSpan(vec2 place)
{
  vec2 first = wfvUnshift(place, -1.0, wfvView) / wfvView.scale;
  vec2 a = 0.5 * (first + wfvUnshift(place, 1.0, wfvView) / wfvView.scale);
  vec2 b = a - first;
  float rim = wfvRadius(wfvView.maxAngle, wfvView);
  float l = length(b);
  wfvSpan = wfvDepths;
  if (!(l > 0.0))
  {
    return true;
  }
  float aside = abs(a.x * b.y - a.y * b.x) / l;
  float middle = -dot(a, b) / (l * l);
  float half_ = sqrt(max((rim - aside) * (rim + aside), 0.0)) / l;
  wfvSpan = vec2(max(wfvSpan.x, middle - half_), min(wfvSpan.y, middle + half_));
  bool any_ = aside < rim && wfvSpan.x <= wfvSpan.y;
  wfvSpan = any_ ? wfvSpan : wfvDepths;
  return any_;
}
#else
float wfvDepthFrom(float t)
{
  return mix(wfvSpan.x, wfvSpan.y, t);
}

bool wfvSetSpan(vec2 place)
{
  wfvSpan = wfvDepths;
  return true;
}
#endif

// By how much the curve is behind the plane at t, times the plane's normal.
float wfvBehind(vec2 place, float t)
{
  float depth = wfvDepthFrom(t);
  float rho = wfvDistanceAt(0.5 * depth + 0.5, wfvView) / wfvScale();
  return dot(wfvPlane, rho * wfvRayOfDepth(place, depth).direction - wfvAnchor);
}

// Whether the cube has the place of the curve at t.
bool wfvInsideAt(vec2 place, float t)
{
#if WFV_ROUND
  vec2 ndc = wfvUnshift(place, wfvDepthFrom(t), wfvView);
  return abs(ndc.x) <= 1.0 && abs(ndc.y) <= 1.0; // inside the map it is anyway
#else
  return wfvRayOfDepth(place, wfvDepthFrom(t)).inside;
#endif
}

// The first of the parts of the span at whose ends the curve is on different sides of the plane,
// and inside the cube at one of them at least; x above y: none.
vec2 wfvCrossedPart(vec2 place)
{
  vec2 part = vec2(1.0, -1.0);
  float before = wfvBehind(place, 0.0);
  bool inside = wfvInsideAt(place, 0.0);
  for (int i = 1; i <= WFV_CURVE_PARTS; i++)
  {
    vec2 ends = vec2(float(i - 1), float(i)) / float(WFV_CURVE_PARTS);
    float here = wfvBehind(place, ends.y);
    bool next = wfvInsideAt(place, ends.y);
    bool crosses = (before <= 0.0) != (here <= 0.0) && (inside || next);
    part = crosses && part.x > part.y ? ends : part;
    before = here;
    inside = next;
  }
  return part;
}

WfvRay wfvSurfaceRay(vec2 offset)
{
  vec2 place = wfvPlaceBeside(offset);
  bool any_ = wfvSetSpan(place);
  vec2 z = wfvCrossedPart(place);
  bool crosses = any_ && z.x <= z.y;
  // beside the triangle, where samples of the pixel may be inside: the end that is nearer to it
  z = crosses ? z : vec2(0.0, 1.0);
  vec2 f = vec2(wfvBehind(place, z.x), wfvBehind(place, z.y));
  float side = 0.0;
  float end = abs(f.x) < abs(f.y) ? z.x : z.y;
  float middle = end;
  for (int i = 0; i < WFV_CURVE_STEPS; i++)
  {
    middle = crosses ? clamp(z.x - f.x * (z.y - z.x) / (f.y - f.x), z.x, z.y) : end;
    float at = wfvBehind(place, middle);
    bool low = (at <= 0.0) == (f.x <= 0.0);
    // the end that stays twice counts for half
    f = low ? vec2(at, side > 0.0 ? 0.5 * f.y : f.y) : vec2(side < 0.0 ? 0.5 * f.x : f.x, at);
    z = low ? vec2(middle, z.y) : vec2(z.x, middle);
    side = low ? 1.0 : -1.0;
  }
  WfvRay ray = wfvRayOfDepth(place, wfvDepthFrom(middle));
  ray.inside = ray.inside && crosses;
  return ray;
}
