// SPDX-License-Identifier: BSD-3-Clause
// Direction map: the pixels of the file, and the ray through any place between them.

// What a pixel's bits say. It has a direction; it is continuous to its neighbour; the four
// pixels of the square to its upper right hang together; it and its eight neighbours lie
// nearly on a grid.
const int WFV_PIXEL_VALID = 1;
const int WFV_PIXEL_RIGHT = 2;
const int WFV_PIXEL_LEFT = 4;
const int WFV_PIXEL_UP = 8;
const int WFV_PIXEL_DOWN = 16;
const int WFV_PIXEL_SQUARE = 32;
const int WFV_PIXEL_SIMPLE = 64;

// Pixels from the lower left pixel's centre.
WFV_FN vec2 wfvPixelOfNdc(vec2 ndc, WfvView v)
{
  return vec2(0.5 * (ndc.x + 1.0) * v.tables.x - 0.5, 0.5 * (ndc.y + 1.0) * v.tables.y - 0.5);
}

WFV_FN vec2 wfvNdcOfPixel(vec2 p, WfvView v)
{
  return vec2(2.0 * (p.x + 0.5) / v.tables.x - 1.0, 2.0 * (p.y + 0.5) / v.tables.y - 1.0);
}

WFV_FN vec3 wfvTexelDirection(vec4 texel)
{
  return vec3(texel.x, texel.y, texel.z);
}

// The step to the next pixel along an axis (ahead: 1, 0 or 0, 1), seen from a place on the
// given side of the centre: that of the other side where there is a discontinuity on this one, else none.
WFV_FN vec3 wfvStepBeside(vec4 here, int x, int y, int alongX, float side, WfvView v)
{
  int bits = int(here.w);
  bool next = (bits & (alongX == 1 ? WFV_PIXEL_RIGHT : WFV_PIXEL_UP)) != 0;
  bool before = (bits & (alongX == 1 ? WFV_PIXEL_LEFT : WFV_PIXEL_DOWN)) != 0;
  int dx = alongX;
  int dy = 1 - alongX;
  vec3 d = wfvTexelDirection(here);
  vec3 change = vec3(0.0, 0.0, 0.0);
  if (next && (side >= 0.0 || !before))
  {
    change = wfvTexelDirection(wfvDirectionTexel(v, x + dx, y + dy)) - d;
  }
  else if (before)
  {
    change = d - wfvTexelDirection(wfvDirectionTexel(v, x - dx, y - dy));
  }
  return change;
}

WFV_FN int wfvNearestIndex(float p, float count)
{
  return int(max(0.0, min(count - 1.0, floor(p + 0.5))));
}

// The direction at a place in the map, in pixels, not of unit length, and its slopes there.
struct WfvAround
{
  vec3 direction;
  vec3 x;
  vec3 y;
  bool inside;
};

WFV_FN WfvAround wfvAround(vec2 p, WfvView v)
{
  int x = wfvNearestIndex(p.x, v.tables.x);
  int y = wfvNearestIndex(p.y, v.tables.y);
  float s = p.x - float(x);
  float t = p.y - float(y);
  vec4 here = wfvDirectionTexel(v, x, y);
  int x0 = s < 0.0 ? x - 1 : x;
  int y0 = t < 0.0 ? y - 1 : y;
  vec4 corner = vec4(0.0, 0.0, 0.0, 0.0);
  if (x0 >= 0 && y0 >= 0)
  {
    corner = wfvDirectionTexel(v, x0, y0);
  }
  WfvAround r;
  r.inside = (int(here.w) & WFV_PIXEL_VALID) != 0;
  if ((int(corner.w) & WFV_PIXEL_SQUARE) != 0)
  {
    float a = p.x - float(x0);
    float b = p.y - float(y0);
    vec3 d00 = wfvTexelDirection(corner);
    vec3 low = wfvTexelDirection(wfvDirectionTexel(v, x0 + 1, y0)) - d00;
    vec3 left = wfvTexelDirection(wfvDirectionTexel(v, x0, y0 + 1)) - d00;
    vec3 twist = wfvTexelDirection(wfvDirectionTexel(v, x0 + 1, y0 + 1)) - d00 - low - left;
    r.x = low + twist * b;
    r.y = left + twist * a;
    r.direction = d00 + r.x * a + left * b;
  }
  else
  {
    r.x = wfvStepBeside(here, x, y, 1, s, v);
    r.y = wfvStepBeside(here, x, y, 0, t, v);
    r.direction = wfvTexelDirection(here) + r.x * s + r.y * t;
  }
  return r;
}

// Pixels of the map: slopes of a pixel are looked at so far on either side of a place, inside it.
const float WFV_SLOPE_RANGE = 0.25;
const float WFV_SLOPE_INSIDE = 0.49;

// A pixel's local map, carried on: the unit vector seen at p, which lies in the pixel, and its slopes
// at right angles to it, with which directions go on beside it. Along an axis on which no neighbour
// hangs with it they change as much as along the other, across it.
WFV_FN WfvAround wfvLocalMap(vec2 p, WfvView v)
{
  vec2 centre = vec2(float(wfvNearestIndex(p.x, v.tables.x)), float(wfvNearestIndex(p.y, v.tables.y)));
  vec2 range = vec2(WFV_SLOPE_RANGE, WFV_SLOPE_RANGE);
  vec2 end = vec2(WFV_SLOPE_INSIDE, WFV_SLOPE_INSIDE);
  vec2 low = max(p - range, centre - end);
  vec2 high = min(p + range, centre + end);
  WfvAround r = wfvAround(p, v);
  float l = wfvHypot(wfvHypot(r.direction.x, r.direction.y), r.direction.z);
  r.direction = l > 0.0 ? r.direction / l : vec3(0.0, 0.0, -1.0);
  float half_ = l > 0.0 ? 0.5 / l : 0.0;
  r.x = half_ * (wfvAround(vec2(low.x, p.y), v).x + wfvAround(vec2(high.x, p.y), v).x);
  r.y = half_ * (wfvAround(vec2(p.x, low.y), v).y + wfvAround(vec2(p.x, high.y), v).y);
  r.x = r.x - r.direction * dot(r.x, r.direction);
  r.y = r.y - r.direction * dot(r.y, r.direction);
  if (dot(r.x, r.x) == 0.0)
  {
    r.x = cross(r.y, r.direction);
  }
  if (dot(r.y, r.y) == 0.0)
  {
    r.y = cross(r.direction, r.x);
  }
  return r;
}

// The ray through a place in the map, pixels.
WFV_FN WfvRay wfvRayOfPixel(vec2 p, WfvView v)
{
  WfvAround here = wfvAround(p, v);
  float l = wfvHypot(wfvHypot(here.direction.x, here.direction.y), here.direction.z);
  WfvRay ray;
  ray.inside = here.inside;
  ray.direction = ray.inside && l > 0.0 ? here.direction / l : vec3(0.0, 0.0, -1.0);
  return ray;
}

WFV_FN WfvRay wfvRayOfMap(vec2 m, WfvView v)
{
  WfvRay ray = wfvRayOfPixel(wfvPixelOfNdc(m, v), v);
  ray.inside = ray.inside && abs(m.x) <= WFV_BORDER && abs(m.y) <= WFV_BORDER;
  return ray;
}
