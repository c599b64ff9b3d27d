// SPDX-License-Identifier: BSD-3-Clause
// Direction map: what pixels may show what lies in a cap of directions.

// Part of a cell's angle that a cap, and the pixels stored in it, may have as their radius,
// so that a cell and its eight neighbours hold all that meets them.
const float WFV_CAP_SHARE = 0.3;

// Cells along a face of the cube on the coarsest level.
const int WFV_COARSEST_CELLS = 4;

// Seeds of a cell: it may lie on so many pieces of the map.
const int WFV_CELL_SEEDS = 4;

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
