// SPDX-License-Identifier: BSD-3-Clause
// Covers a triangle for direction maps, of which nothing is known but their tables: the
// caps round its parts (wfvCapPlaces), in one rectangle or two.

// Parts along an edge of a triangle that is larger than a cell.
const int WFV_PARTS = 4;

// The largest chord for which the angle over it is at most so many chords.
const float WFV_CAP_CHORD = 1.0;
const float WFV_CAP_ANGLE = 1.05;

vec3 wfvPartCorner(int i, int j)
{
  float a = float(i) / float(WFV_PARTS);
  float b = float(j) / float(WFV_PARTS);
  vec3 p = (1.0 - a - b) * wfvP[0] + a * wfvP[1] + b * wfvP[2];
  return p / max(length(p), 1e-30);
}

// What shows a triangle of directions.
WfvPlaces wfvPart(vec3 a, vec3 b, vec3 c)
{
  vec3 sum = a + b + c;
  vec3 centre = sum / max(length(sum), 1e-30);
  float chord = max(length(a - centre), max(length(b - centre), length(c - centre)));
  float angle = chord < WFV_CAP_CHORD ? WFV_CAP_ANGLE * chord + WFV_ANGLE_PAD : WFV_PI;
#if WFV_OWN_RAYS
  angle = min(angle + wfvGrow, WFV_PI);
#endif
  return wfvCapPlaces(centre, angle, wfvView);
}

// Pixels of the direction map: larger rectangles are taken as they are.
const float WFV_CLOSE_PIXELS = 24.0;

// The rectangle of a cell or, where it is small and calm, what lies round three corners.
vec4 wfvClose(WfvPlaces cell, vec3 a, vec3 b, vec3 c)
{
  vec4 r = cell.first;
  vec2 low = wfvPixelOfNdc(r.xy, wfvView);
  vec2 high = wfvPixelOfNdc(r.zw, wfvView);
  vec2 middle = 0.5 * (low + high);
  if (WFV_OWN_RAYS == 1 || !cell.calm || !(max(high.x - low.x, high.y - low.y) < WFV_CLOSE_PIXELS))
  {
    return r;
  }
  vec3 p = wfvFindFrom(middle, a, wfvView);
  vec3 q = wfvFindFrom(middle, b, wfvView);
  vec3 s = wfvFindFrom(middle, c, wfvView);
  if (!(max(p.z, max(q.z, s.z)) < WFV_SEARCH_REST))
  {
    return r;
  }
  vec2 least = min(p.xy, min(q.xy, s.xy));
  vec2 most = max(p.xy, max(q.xy, s.xy));
  float grow = WFV_CLOSE_BEND * dot(most - least, most - least) + WFV_SEARCH_REST;
  return vec4(max(r.xy, wfvNdcOfPixel(least - grow, wfvView)),
    min(r.zw, wfvNdcOfPixel(most + grow, wfvView)));
}

// Padded, and clipped to the window.
vec4 wfvGrown(vec4 r)
{
  vec2 pad = 2.0 * WFV_PAD / (wfvViewport.zw * wfvTile.xy);
  return vec4(max(r.xy - pad, vec2(-1.0)), min(r.zw + pad, vec2(1.0)));
}

// The parts of a triangle that is larger than a cell.
WfvPlaces wfvParts()
{
  WfvPlaces places = wfvNoPlaces();
  for (int i = 0; i < WFV_PARTS; i++)
  {
    for (int j = 0; j < WFV_PARTS - i; j++)
    {
      vec3 right = wfvPartCorner(i + 1, j);
      vec3 up = wfvPartCorner(i, j + 1);
      places = wfvWithPlaces(places, wfvPart(wfvPartCorner(i, j), right, up));
      if (i + j + 2 <= WFV_PARTS)
      {
        places = wfvWithPlaces(places, wfvPart(wfvPartCorner(i + 1, j + 1), right, up));
      }
    }
  }
  return places;
}

void wfvCover(bool front)
{
  vec3 a = wfvPartCorner(0, 0);
  vec3 b = wfvPartCorner(WFV_PARTS, 0);
  vec3 c = wfvPartCorner(0, WFV_PARTS);
  float longest = max(length(b - c), max(length(c - a), length(a - b)));
  WfvPlaces places = wfvNoPlaces();
  if (longest * wfvView.tables.z > WFV_CAP_SHARE * 0.5 * WFV_PI)
  {
    places = wfvParts();
  }
  else
  {
    places = wfvPart(a, b, c);
    places.first = wfvClose(places, a, b, c);
  }
  places.first = wfvGrown(places.first);
  places.second = wfvGrown(places.second);
  places = wfvApart(places);
  wfvEmitRectangle(places.first, front);
  wfvEmitRectangle(places.second, front);
}
