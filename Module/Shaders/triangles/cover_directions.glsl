// SPDX-License-Identifier: BSD-3-Clause
// Covers a triangle for direction maps, of which nothing is known but their tables: what lies round
// its corners where the map is one even piece, else the caps round its parts (wfvCapPlaces), in one
// rectangle or two.

// Parts along an edge of a triangle that is larger than a cell, at the most.
const int WFV_PARTS = 16;

// The corner i, j of so many parts along an edge.
vec3 wfvPartCorner(int i, int j, float parts)
{
  float a = float(i) / parts;
  float b = float(j) / parts;
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
#if WFV_NON_CENTRAL
  angle = min(angle + wfvGrow, WFV_PI);
#endif
  return wfvCapPlaces(centre, angle, wfvView);
}

// With one more part. The curvature is the larger one: parts that are one piece each are one together,
// for each shares corners, which no other place sees, with the next.
WfvPlaces wfvWithPart(WfvPlaces places, WfvPlaces part)
{
  WfvPlaces all = wfvWithPlaces(places, part);
  all.curvature = max(places.curvature, part.curvature);
  return all;
}

// The parts of a triangle.
WfvPlaces wfvParts(int parts)
{
  WfvPlaces places = wfvNoPlaces();
  places.curvature = 0.0;
  float count = float(parts);
  for (int i = 0; i < parts; i++)
  {
    for (int j = 0; j < parts - i; j++)
    {
      vec3 right = wfvPartCorner(i + 1, j, count);
      vec3 up = wfvPartCorner(i, j + 1, count);
      places = wfvWithPart(places, wfvPart(wfvPartCorner(i, j, count), right, up));
      if (i + j + 2 <= parts)
      {
        places = wfvWithPart(places, wfvPart(wfvPartCorner(i + 1, j + 1, count), right, up));
      }
    }
  }
  return places;
}

// The place of a direction that one rectangle shows, pixels of the direction map; z: by how many it is
// missed.
vec3 wfvPlaceOf(vec3 d)
{
  WfvPlaces cap = wfvCapPlaces(d, WFV_ANGLE_PAD, wfvView);
  vec3 found = vec3(0.0, 0.0, 1e9);
  if (cap.curvature < 1.0)
  {
    vec2 low = wfvPixelOfNdc(cap.first.xy, wfvView);
    vec2 high = wfvPixelOfNdc(cap.first.zw, wfvView);
    found = wfvFindFrom(0.5 * (low + high), d, wfvView);
    bool inside = all(greaterThanEqual(found.xy, low)) && all(lessThanEqual(found.xy, high));
    found.z = inside ? found.z : 1e9;
  }
  return found;
}

// Pixels of the tile, from its centre.
vec2 wfvPixelOfPlace(vec2 place)
{
  return 0.5 * wfvViewport.zw * (wfvNdcOfPixel(place, wfvView) * wfvTile.xy + wfvTile.zw);
}

// Covers a triangle that is one piece by what lies round its corners; false where that is not found.
bool wfvCoverClose(float curvature, vec3 a, vec3 b, vec3 c, bool front)
{
  if (WFV_NON_CENTRAL == 1 || !(curvature < 1.0))
  {
    return false;
  }
  vec3 p = wfvPlaceOf(a);
  vec3 q = wfvPlaceOf(b);
  vec3 s = wfvPlaceOf(c);
  vec2 size = max(p.xy, max(q.xy, s.xy)) - min(p.xy, min(q.xy, s.xy));
  float beside = wfvBesideChord(length(size), curvature);
  if (!(max(p.z, max(q.z, s.z)) < WFV_SEARCH_REST && beside < WFV_ASTRAY))
  {
    return false;
  }
  vec2 texel = wfvViewport.zw * wfvTile.xy / wfvView.tables.xy; // pixels
  float grow = beside + WFV_SEARCH_REST;
  wfvC[0] = wfvPixelOfPlace(p.xy);
  wfvC[1] = wfvPixelOfPlace(q.xy);
  wfvC[2] = wfvPixelOfPlace(s.xy);
  wfvEmitShape(wfvShapeRound(vec3(grow * max(texel.x, texel.y) + WFV_TIGHT_PAD), front));
  return true;
}

// Padded, and clipped to the window.
vec4 wfvGrown(vec4 r)
{
  vec2 pad = 2.0 * WFV_PAD / (wfvViewport.zw * wfvTile.xy);
  return vec4(max(r.xy - pad, vec2(-1.0)), min(r.zw + pad, vec2(1.0)));
}

void wfvCover(bool front)
{
  vec3 a = wfvPartCorner(0, 0, 1.0);
  vec3 b = wfvPartCorner(1, 0, 1.0);
  vec3 c = wfvPartCorner(0, 1, 1.0);
  float longest = max(length(b - c), max(length(c - a), length(a - b)));
  float cells = longest * wfvView.tables.z / (WFV_CAP_SHARE * 0.5 * WFV_PI);
  WfvPlaces places = wfvParts(int(clamp(ceil(cells), 1.0, float(WFV_PARTS))));
  if (wfvCoverClose(places.curvature, a, b, c, front))
  {
    return;
  }
  places.first = wfvGrown(places.first);
  places.second = wfvGrown(places.second);
  places = wfvApart(places);
  wfvEmitRectangle(places.first, front);
  wfvEmitRectangle(places.second, front);
}
