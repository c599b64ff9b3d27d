// SPDX-License-Identifier: BSD-3-Clause
// Shared by the maps of longitude and latitude. Included after the projection.

// NDC rectangle (x min, y min, x max, y max) of a rectangle of angles (the same order).
// Holds for every map in which x grows with lambda and, in size, towards the equator
// (or not with phi at all), and y grows with phi and, in size, with |lambda| (or not at
// all): the extremes are then at corners, and on the equator or the central meridian.
WFV_FN vec4 wfvBounds(vec4 a, WfvView v)
{
  float nearEquator = a.y > 0.0 ? a.y : (a.w < 0.0 ? a.w : 0.0);
  float farEquator = abs(a.y) > abs(a.w) ? a.y : a.w;
  float nearCentre = a.x > 0.0 ? a.x : (a.z < 0.0 ? a.z : 0.0);
  float farCentre = abs(a.x) > abs(a.z) ? a.x : a.z;
  return vec4(wfvMap(vec2(a.x, a.x < 0.0 ? nearEquator : farEquator), v).x,
    wfvMap(vec2(a.y < 0.0 ? farCentre : nearCentre, a.y), v).y,
    wfvMap(vec2(a.z, a.z > 0.0 ? nearEquator : farEquator), v).x,
    wfvMap(vec2(a.w > 0.0 ? farCentre : nearCentre, a.w), v).y);
}
