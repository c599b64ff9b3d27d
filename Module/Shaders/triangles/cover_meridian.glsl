// SPDX-License-Identifier: BSD-3-Clause
// Covers a triangle for maps of longitude and latitude whose meridians are upright: columns that are as
// high as the triangle is, in two parts where it reaches across the seam.

// Sine of the angle to the axis at which the plane of an edge counts as upright.
const float WFV_UPRIGHT = 1e-6;

// Pixels: a rasterizer moves the border of a column by as much (1/256 for eight bits below the
// pixel, and what float32 rounds of its place). A column takes its heights from so much more on
// either side, or what is narrower than this would be drawn as high as it is somewhere else.
const float WFV_COLUMN_SNAP = 1.0 / 64.0;

// Radians: a column widened by more is no longer less than half a turn wide.
const float WFV_WIDEST_TURN = 1.8;

// Range of the tangent of the latitude that one edge leaves the triangle between two
// longitudes at most half a turn apart: x above y: none. n: the edge's plane, inside up.
vec2 wfvEdgeRange(vec3 n, vec2 lambda)
{
  // inside: slope sin(lambda - turn) + n.y tan(latitude) >= 0
  float slope = wfvHypot(n.x, n.z);
  float turn = wfvAtan2(n.z, n.x);
  vec2 ends = slope * sin(lambda - turn);
  float most = wfvWrap(0.5 * (lambda.x + lambda.y) - turn - 0.5 * WFV_PI);
  float half_ = 0.5 * (lambda.y - lambda.x);
  float high = abs(most) <= half_ ? slope : max(ends.x, ends.y);
  float slack = WFV_UPRIGHT * length(n);
  if (abs(n.y) <= slack)
  {
    return high < -slack ? vec2(1e30, -1e30) : vec2(-1e30, 1e30);
  }
  return n.y > 0.0 ? vec2(-high / n.y, 1e30) : vec2(-1e30, high / -n.y);
}

// NDC of the lowest and the highest latitude of the triangle between two longitudes, or as near to
// them as a rasterizer moves them; none where it is not asked for.
vec2 wfvColumn(vec2 lambda, bool asked)
{
  float snap = 2.0 * WFV_COLUMN_SNAP / (wfvViewport.z * wfvTile.x * wfvView.scale.x);
  lambda += vec2(-snap, snap);
  vec2 r = vec2(-1e30, 1e30);
  float pad = WFV_ANGLE_PAD;
#if WFV_NON_CENTRAL
  pad += wfvGrow;
#endif
  vec3 plane = wfvN[0];
  vec3 next = wfvN[1];
  for (int i = asked ? 3 : 0; i > 0; i--) // see wfvMustCover
  {
#if WFV_NON_CENTRAL
    vec2 edge = wfvEdgeRange(plane, lambda - wfvNcTurns.yx);
    edge = wfvNcTurns.y - wfvNcTurns.x < WFV_WIDEST_TURN ? edge : vec2(-1e30, 1e30);
#else
    vec2 edge = wfvEdgeRange(plane, lambda);
#endif
    r = vec2(max(r.x, edge.x), min(r.y, edge.y));
    plane = next;
    next = wfvN[2];
  }
  if (!asked || r.x > r.y)
  {
    return vec2(1e9, -1e9);
  }
  vec2 phi = vec2(wfvAtan2(r.x, 1.0) - pad, wfvAtan2(r.y, 1.0) + pad);
#if WFV_NON_CENTRAL
  phi = clamp(phi, wfvNcBand.x, wfvNcBand.y);
#endif
  phi = clamp(phi, -0.5 * WFV_PI, 0.5 * WFV_PI);
  vec4 b = wfvBounds(vec4(lambda.x, phi.x, lambda.y, phi.y), wfvView);
  float border = 2.0 * WFV_PAD / (wfvViewport.w * wfvTile.y);
  return vec2(max(b.y - border, -1.0), min(b.w + border, 1.0));
}

// Pixels: columns end at multiples of it. Rasterizers run fragment programs for whole blocks of pixels,
// and software ones of 4 x 4 would run them twice for those that two columns share.
const float WFV_COLUMN_BLOCK = 4.0;

// The longitude of the border of a block that is nearest to one.
float wfvToBlock(float lambda)
{
  float perRadian = 0.5 * wfvViewport.z * wfvTile.x * wfvView.scale.x;
  float middle = wfvViewport.x + 0.5 * wfvViewport.z * (1.0 + wfvTile.z);
  float block = floor((middle + lambda * perRadian) / WFV_COLUMN_BLOCK + 0.5);
  return (block * WFV_COLUMN_BLOCK - middle) / perRadian;
}

// One of the borders of so many columns between two longitudes.
float wfvColumnBorder(vec2 lambda, int i, int all)
{
  float at = mix(lambda.x, lambda.y, float(i) / float(all));
  return i <= 0 || i >= all ? at : clamp(wfvToBlock(at), lambda.x, lambda.y);
}

// From one longitude to another, in so many columns a run, each as high as the triangle is there:
// strips that hit no pixel twice.
void wfvEmitColumns(vec2 lambda, int columns, bool front)
{
  float pad = 2.0 * WFV_PAD / (wfvViewport.z * wfvTile.x);
  int all = columns * WFV_RUNS;
  int first = 0;
#if WFV_RUNS > 1
  first = columns * WFV_RUN;
  wfvMute = false;
#endif
  int last = first + columns;
  vec2 before = vec2(1e9, -1e9);
  for (int i = first; i <= last; i++)
  {
    vec2 at = vec2(wfvColumnBorder(lambda, i, all), wfvColumnBorder(lambda, i + 1, all));
    vec2 here = wfvColumn(at, i < last);
    vec2 y = vec2(min(before.x, here.x), max(before.y, here.y));
    float x = wfvMap(vec2(at.x, 0.0), wfvView).x;
    x = clamp(x + (i == 0 ? -pad : (i == all ? pad : 0.0)), -1.0, 1.0);
    before = here;
    // both ends of the border between two columns, if it has any
    for (int end = y.x <= y.y ? 2 : 0; end > 0; end--)
    {
      vec2 place = vec2(x, (end == 2) == front ? y.y : y.x);
      wfvEmit(vec4(place * wfvTile.xy + wfvTile.zw, 0.0, 1.0), vec3(0.0));
    }
    if (here.x > here.y)
    {
      wfvEnd();
    }
  }
}

// Columns that the stage may emit in all.
const int WFV_COLUMNS = 6;

void wfvCover(bool front)
{
  // with a corner at the pole it has the azimuths of the other two
  bool pole = (wfvHolds(1, 1.0) || wfvHolds(1, -1.0)) &&
    !wfvCornerAtPole(vec3(0.0, 1.0, 0.0));
  vec4 a = wfvAngularBounds(vec3(0.0, 1.0, 0.0));
#if WFV_NON_CENTRAL
  wfvNcSet(a, wfvHolds(1, 1.0) || wfvHolds(1, -1.0));
  a += vec4(wfvNcTurns.x, 0.0, wfvNcTurns.y, 0.0);
  wfvNcBand.x = wfvHolds(1, -1.0) ? -0.5 * WFV_PI : wfvNcBand.x;
  wfvNcBand.y = wfvHolds(1, 1.0) ? 0.5 * WFV_PI : wfvNcBand.y;
#endif
  bool round_ = pole || a.z - a.x >= 2.0 * WFV_PI;
  vec2 here = round_ ? vec2(-WFV_PI, WFV_PI) : vec2(max(a.x, -WFV_PI), min(a.z, WFV_PI));
  vec2 across = vec2(0.0);
  if (!round_ && a.z > WFV_PI)
  {
    across = vec2(-WFV_PI, a.z - 2.0 * WFV_PI);
  }
  else if (!round_ && a.x < -WFV_PI)
  {
    across = vec2(a.x + 2.0 * WFV_PI, WFV_PI);
  }
  bool two = across.x < across.y;
  bool wide = here.y - here.x > across.y - across.x;
  for (int part = two ? 2 : 1; part > 0; part--)
  {
    bool last = two && part == 1;
    wfvEmitColumns(last ? across : here, !two ? WFV_COLUMNS : wide != last ? 2 : 1, front);
  }
}
