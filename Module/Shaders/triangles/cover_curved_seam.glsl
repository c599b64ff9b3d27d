// SPDX-License-Identifier: BSD-3-Clause
// Covers a triangle for maps of longitude and latitude whose seam is curved: a rectangle of angles, two
// where it reaches across the seam. Where parallels are short, towards a pole, the two overlap in the
// picture: there they are one, lest a pixel be hit twice.

void wfvCover(bool front)
{
  bool north = wfvHolds(1, 1.0);
  bool south = wfvHolds(1, -1.0);
  vec4 a = wfvAngularBounds(vec3(0.0, 1.0, 0.0));
#if WFV_NON_CENTRAL
  wfvNcSet(a, north || south);
  a = vec4(a.x + wfvNcTurns.x, wfvNcBand.x, a.z + wfvNcTurns.y, wfvNcBand.y);
#endif
  a = vec4(a.x, south ? -0.5 * WFV_PI : max(a.y, -0.5 * WFV_PI), a.z,
    north ? 0.5 * WFV_PI : min(a.w, 0.5 * WFV_PI));
  bool round_ = (north || south) && !wfvCornerAtPole(vec3(0.0, 1.0, 0.0));
  if (round_ || a.z - a.x >= 2.0 * WFV_PI)
  {
    wfvEmitRectangle(wfvPadded(vec4(-WFV_PI, a.y, WFV_PI, a.w)), front);
    return;
  }
  float turn = 2.0 * WFV_PI;
  vec4 here = wfvPadded(vec4(max(a.x, -WFV_PI), a.y, min(a.z, WFV_PI), a.w));
  if (a.z <= WFV_PI && a.x >= -WFV_PI)
  {
    wfvEmitRectangle(here, front);
    return;
  }
  vec4 across = wfvPadded(a.z > WFV_PI ? vec4(-WFV_PI, a.y, a.z - turn, a.w)
                                       : vec4(a.x + turn, a.y, WFV_PI, a.w));
  if (max(here.x, across.x) < min(here.z, across.z))
  {
    wfvEmitRectangle(vec4(min(here.xy, across.xy), max(here.zw, across.zw)), front);
    return;
  }
  wfvEmitRectangle(here, front);
  wfvEmitRectangle(across, front);
}
