// SPDX-License-Identifier: BSD-3-Clause
// Direction map: any display, lens or mirror, described by one direction a pixel. The ray of
// a pixel's centre is the file's own; between centres directions are bilinear, except where
// the map is discontinuous: there each pixel goes on by its own slope up to its edge.
// Domain: the pixels that have a direction. Discontinuities: wherever the file has them.
// Source: what wfv::DirectionMap (DirectionMap.h) made of the file, in three tables:
//   vec4 wfvDirectionTexel(WfvView v, int x, int y)  the direction of a pixel, and its bits
//   vec4 wfvCellTexel(WfvView v, int x, int y)       one of the two NDC rectangles of the
//                                                    pixels round a cell: wfvCapPlaces
//   vec4 wfvSeedTexel(WfvView v, int x, int y)       two pixels of a cell of the finest level

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

// NDC of a direction that no pixel shows.
const float WFV_ELSEWHERE = 4.0;

// Part of a cell's angle that a cap, and the pixels stored in it, may have as their radius,
// so that a cell and its eight neighbours hold all that meets them.
const float WFV_CAP_SHARE = 0.3;

// Cells along a face of the cube on the coarsest level.
const int WFV_COARSEST_CELLS = 4;

// Seeds of a cell: it may lie on so many pieces of the map.
const int WFV_CELL_SEEDS = 4;

// Steps of the search for the pixel of a direction, the longest of them, and the rest that
// is as good as none and that counts as found, pixels.
const int WFV_SEARCH_STEPS = 12;
const float WFV_SEARCH_STEP = 16.0;
const float WFV_SEARCH_END = 1e-4;
const float WFV_SEARCH_REST = 0.01;

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

// Cell of the sphere that a direction meets, of so many along a face: column (all six faces
// side by side) and row.
WFV_FN int wfvCellColumn(vec3 d, int cells)
{
  int face = wfvFaceOf(d);
  vec3 q = wfvInFace(d, face);
  float u = 0.5 + 2.0 / WFV_PI * wfvAtan2(q.x, q.z);
  return face * cells + wfvNearestIndex(u * float(cells) - 0.5, float(cells));
}

WFV_FN int wfvCellRow(vec3 d, int cells)
{
  vec3 q = wfvInFace(d, wfvFaceOf(d));
  float u = 0.5 + 2.0 / WFV_PI * wfvAtan2(q.y, q.z);
  return wfvNearestIndex(u * float(cells) - 0.5, float(cells));
}

// Two rectangles of the picture (x min, y min, x max, y max; NDC): what lies together is
// often shown in two places, on both sides of a seam. x min above x max: none.
struct WfvPlaces
{
  vec4 first;
  vec4 second;
  bool simple; // of a cell: all its pixels are
  float curvature; // of a single rectangle: steps of pixels in it change from one to the next by no larger
              // part of them, and no two of its places see one direction; 1 or more: not known
};

WFV_FN WfvPlaces wfvNoPlaces()
{
  WfvPlaces none;
  none.first = vec4(1e9, 1e9, -1e9, -1e9);
  none.second = none.first;
  none.simple = true;
  none.curvature = 1.0;
  return none;
}

WFV_FN vec4 wfvUnited(vec4 a, vec4 b)
{
  return vec4(min(a.x, b.x), min(a.y, b.y), max(a.z, b.z), max(a.w, b.w));
}

// The larger of the gaps between two rectangles along x and y; at most 0: they meet.
WFV_FN float wfvGap(vec4 a, vec4 b)
{
  return max(max(a.x, b.x) - min(a.z, b.z), max(a.y, b.y) - min(a.w, b.w));
}

// NDC: rectangles that are nearer than this are not worth two.
const float WFV_WORTH_TWO = 0.02;

// With one more rectangle, in the nearer of the two.
WFV_FN WfvPlaces wfvWithPlace(WfvPlaces places, vec4 r)
{
  WfvPlaces result = places;
  bool two = places.second.x <= places.second.z;
  float first = places.first.x <= places.first.z ? wfvGap(places.first, r) : 0.0;
  float second = two ? wfvGap(places.second, r) : WFV_WORTH_TWO;
  if (r.x <= r.z && first <= second)
  {
    result.first = wfvUnited(places.first, r);
  }
  else if (r.x <= r.z)
  {
    result.second = wfvUnited(places.second, r);
  }
  return result;
}

WFV_FN WfvPlaces wfvWithPlaces(WfvPlaces places, WfvPlaces more)
{
  WfvPlaces result = wfvWithPlace(wfvWithPlace(places, more.first), more.second);
  result.simple = places.simple && more.simple;
  result.curvature = 1.0;
  return result;
}

// As one rectangle where the two meet, lest a pixel be in both.
WFV_FN WfvPlaces wfvApart(WfvPlaces places)
{
  WfvPlaces result = places;
  bool both = places.first.x <= places.first.z && places.second.x <= places.second.z;
  if (both && wfvGap(places.first, places.second) <= 0.0)
  {
    result.first = wfvUnited(places.first, places.second);
    result.second = wfvNoPlaces().second;
  }
  return result;
}

// Among simple pixels a step differs from the next by so much of it at the most, so a straight edge of n
// pixels curves by no more than an eighth of this times n squared; twice that.
const float WFV_SIMPLE_CHANGE = 0.05;
const float WFV_CLOSE_CURVATURE = 0.25 * WFV_SIMPLE_CHANGE;

// The largest chord for which the angle over it is at most so many chords.
const float WFV_CAP_CHORD = 1.0;
const float WFV_CAP_ANGLE = 1.05;

// Pixels that an edge reaches beyond its ends, for the kinks between pixels.
const float WFV_EDGE_KINKS = 2.0;

// Pixels of an edge times the curvature (WfvPlaces) of where it lies: up to this nothing is known of more.
const float WFV_EDGE_LIMIT = 0.5;

// Of the curvature times the length squared: so far a straight edge lies beside its chord. It curves
// by at most twice as much, and a circle is a little more than a parabola.
const float WFV_EDGE_SIDE = 0.3;

// Pixels: not known.
const float WFV_ASTRAY = 1e9;

// Pixels of the map that the picture of a straight edge may lie beside its chord, which is so long.
WFV_FN float wfvBesideChord(float chord, float curvature)
{
  float far = chord + WFV_EDGE_KINKS;
  return curvature * far <= WFV_EDGE_LIMIT ? WFV_EDGE_SIDE * curvature * far * far : WFV_ASTRAY;
}

// What is added to the left side of the first rectangle in the table where a cell is simple.
const float WFV_SIMPLE_CELL = 16.0;

// All pixels whose ray may lie within so many radians of a unit vector.
WFV_FN WfvPlaces wfvCapPlaces(vec3 centre, float angle, WfvView v)
{
  int cells = int(v.tables.z);
  while (cells > WFV_COARSEST_CELLS && angle * float(cells) > WFV_CAP_SHARE * 0.5 * WFV_PI)
  {
    cells = cells / 2;
  }
  WfvPlaces places = wfvNoPlaces();
  places.first = vec4(-1.0, -1.0, 1.0, 1.0);
  places.simple = false;
  if (angle * float(cells) <= WFV_CAP_SHARE * 0.5 * WFV_PI)
  {
    // level upon level, each twice as high as the one before
    int row = cells - WFV_COARSEST_CELLS + wfvCellRow(centre, cells);
    int column = 2 * wfvCellColumn(centre, cells);
    places.first = wfvCellTexel(v, column, row);
    places.second = wfvCellTexel(v, column + 1, row);
    places.simple = places.first.x > 0.5 * WFV_SIMPLE_CELL && places.first.x < 2.0 * WFV_SIMPLE_CELL;
    places.first.x = places.simple ? places.first.x - WFV_SIMPLE_CELL : places.first.x;
    places.curvature = places.second.x <= places.second.z ? 1.0 : places.second.y;
  }
  return places;
}

// The place in the map, pixels, whose ray is a unit vector, from a place near it; z: by how
// many pixels it is missed.
WFV_FN vec3 wfvFindFrom(vec2 start, vec3 d, WfvView v)
{
  vec2 p = start;
  float rest = 1e9;
  for (int i = 0; i < WFV_SEARCH_STEPS; i++)
  {
    WfvAround here = wfvAround(p, v);
    vec3 e = d - here.direction / wfvHypot(wfvHypot(here.direction.x, here.direction.y), here.direction.z);
    vec3 gx = here.x;
    vec3 gy = here.y;
    float a = dot(gx, gx);
    float b = dot(gx, gy);
    float c = dot(gy, gy);
    float det = a * c - b * b;
    if (!(det > 0.0))
    {
      return vec3(p.x, p.y, 1e9);
    }
    vec2 change = vec2((c * dot(gx, e) - b * dot(gy, e)) / det, (a * dot(gy, e) - b * dot(gx, e)) / det);
    float l = wfvHypot(change.x, change.y);
    // what is left across the surface: the far side of the sphere has the same slope
    rest = dot(e, e) < 1.0 ? l : 1e9;
    if (rest < WFV_SEARCH_END)
    {
      return vec3(p.x + change.x, p.y + change.y, rest);
    }
    p = p + change * min(1.0, WFV_SEARCH_STEP / l);
    p = vec2(max(-0.5, min(v.tables.x - 0.5, p.x)), max(-0.5, min(v.tables.y - 0.5, p.y)));
  }
  return vec3(p.x, p.y, rest);
}

WFV_FN vec2 wfvProject(vec3 p, WfvView v)
{
  vec3 d = p / wfvHypot(wfvHypot(p.x, p.y), p.z);
  int cells = int(v.tables.z);
  int column = wfvCellColumn(d, cells);
  int row = wfvCellRow(d, cells);
  vec2 place = vec2(WFV_ELSEWHERE, WFV_ELSEWHERE);
  float best = WFV_SEARCH_REST;
  for (int i = 0; i < WFV_CELL_SEEDS && best >= WFV_SEARCH_REST; i++)
  {
    vec4 seeds = wfvSeedTexel(v, 2 * column + i / 2, row);
    vec2 seed = i % 2 == 0 ? vec2(seeds.x, seeds.y) : vec2(seeds.z, seeds.w);
    vec3 found = vec3(0.0, 0.0, 1e9);
    if (seed.x >= 0.0)
    {
      found = wfvFindFrom(seed, d, v);
    }
    if (found.z < best)
    {
      best = found.z;
      place = wfvNdcOfPixel(vec2(found.x, found.y), v);
    }
  }
  return place;
}

// Map of (lambda, phi) in radians.
WFV_FN vec2 wfvMap(vec2 angles, WfvView v)
{
  return wfvProject(wfvMeridianDirection(angles), v);
}

// NDC rectangle of a rectangle of angles: all of the picture. The stages bound what they
// draw by caps.
WFV_FN vec4 wfvBounds(vec4 a, WfvView v)
{
  return vec4(-1.0, -1.0, 1.0, 1.0);
}
