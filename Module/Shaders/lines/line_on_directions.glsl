// SPDX-License-Identifier: BSD-3-Clause
// Lines, geometry stage, for direction maps: a rectangle along each part of the line where the map
// is simple; elsewhere what caps round it meet, in one rectangle or two, as of triangles
// (cover_directions.glsl).

// Cells of the map's finest level: so long are parts, if there are not too many; some six pixels.
const float WFV_LINE_CELLS = 2.0;
const int WFV_LINE_PARTS = WFV_LINE_VERTICES / 8;

// Radians: caps round a part are no larger.
const float WFV_LINE_CAP = 0.2;

// Pixels of the direction map between the ends of a part, at the most, along which a rectangle is
// laid.
const float WFV_LINE_CLOSE = 32.0;

WfvPlaces wfvPlacesOf(float lo, float hi)
{
  WfvPlaces places = wfvNoPlaces();
  int caps = int(max(ceil((hi - lo) / WFV_LINE_CAP), 1.0));
  float angle = (hi - lo) / float(caps);
  float footprint = wfvFootprint(0.5 * wfvLineWidth + WFV_LINE_THIN_PAD);
  for (int i = 0; i < caps; i++)
  {
    vec3 middle = wfvArcAt(lo + (float(i) + 0.5) * angle);
    places = wfvWithPlaces(places, wfvCapPlaces(middle, 0.5 * angle + footprint, wfvView));
  }
  return places;
}

// Emits a rectangle along a part; false where its places are not all simple and near each other.
bool wfvEmitClose(WfvPlaces places, float lo, float hi)
{
  vec4 r = places.first;
  if (!wfvIsSimplePlace(places))
  {
    return false;
  }
  vec3 m = wfvFindIn(r, wfvMiddleOf(r), wfvArcAt(0.5 * (lo + hi)));
  vec3 p = wfvFindIn(r, m.xy, wfvArcAt(lo));
  vec3 q = wfvFindIn(r, m.xy, wfvArcAt(hi));
  float chord = length(q.xy - p.xy);
  float sagitta = WFV_CLOSE_CURVATURE * chord * chord + WFV_SEARCH_REST;
  if (!(max(p.z, max(m.z, q.z)) < WFV_SEARCH_REST && chord < WFV_LINE_CLOSE &&
        length(m.xy - 0.5 * (p.xy + q.xy)) <= sagitta))
  {
    return false;
  }
  vec2 texel = wfvViewport.zw * wfvTile.xy / wfvView.tables.xy; // pixels
  float grow = sagitta + wfvCarriedOn(0.5 * wfvLineWidth / min(texel.x, texel.y));
  wfvEmitAlong(wfvTilePixel(wfvNdcOfPixel(p.xy, wfvView)),
    wfvTilePixel(wfvNdcOfPixel(q.xy, wfvView)), wfvLineGrow() + grow * max(texel.x, texel.y));
  return true;
}

void wfvEmitPlace(vec4 r)
{
  vec2 low = wfvTilePixel(r.xy) - WFV_LINE_PAD;
  vec2 size = wfvTilePixel(r.zw) + WFV_LINE_PAD - low;
  if (r.x <= r.z && r.y <= r.w)
  {
    wfvEmitPixels(low, vec2(size.x, 0.0), vec2(0.0, size.y));
  }
}

void wfvEmitPart(float lo, float hi)
{
  WfvPlaces places = wfvPlacesOf(lo, hi);
  if (!wfvEmitClose(places, lo, hi))
  {
    places = wfvApart(places);
    wfvEmitPlace(places.first);
    wfvEmitPlace(places.second);
  }
}

void wfvEmitOnDirections(bool dots)
{
  vec2 ends = wfvArcEnds.xy;
  float many = (ends.y - ends.x) * wfvView.tables.z / WFV_LINE_CELLS;
  int parts = dots ? 2 : int(clamp(ceil(many), 1.0, float(WFV_LINE_PARTS)));
  wfvModeOut = dots ? 3 : 2;
  float lo = ends.x;
  for (int i = 0; i < parts; i++)
  {
    float hi = i + 1 < parts ? mix(ends.x, ends.y, float(i + 1) / float(parts)) : ends.y;
    wfvMapOut = vec4(0.0, 0.0, i > 0 ? lo : -WFV_NO_CUT, i + 1 < parts ? hi : WFV_NO_CUT);
    wfvEmitPart(dots && i > 0 ? hi : lo, dots && i == 0 ? lo : hi);
    lo = hi;
  }
}
