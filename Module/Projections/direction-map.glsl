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

// NDC of a direction that no pixel shows.
const float WFV_ELSEWHERE = 4.0;

// Steps of the search for the pixel of a direction, the longest of them, and the rest that
// is as good as none and that counts as found, pixels.
const int WFV_SEARCH_STEPS = 12;
const float WFV_SEARCH_STEP = 16.0;
const float WFV_SEARCH_END = 1e-4;
const float WFV_SEARCH_REST = 0.01;

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
