// SPDX-License-Identifier: BSD-3-Clause
// Covers a triangle for maps of longitude and latitude: a rectangle of angles, in two
// parts where it reaches across the seam.

void wfvCover(bool front, float facing)
{
  bool north = wfvHolds(1, 1.0, facing);
  bool south = wfvHolds(1, -1.0, facing);
  vec4 a = wfvAngularBounds(vec3(0.0, 1.0, 0.0));
  a = vec4(a.x, south ? -0.5 * WFV_PI : max(a.y, -0.5 * WFV_PI), a.z,
    north ? 0.5 * WFV_PI : min(a.w, 0.5 * WFV_PI));
  bool round_ = (north || south) && !wfvCornerAtPole(vec3(0.0, 1.0, 0.0));
  if (round_ || a.z - a.x >= 2.0 * WFV_PI)
  {
    wfvEmitRectangle(vec4(-WFV_PI, a.y, WFV_PI, a.w), front);
    return;
  }
  float turn = 2.0 * WFV_PI;
  wfvEmitRectangle(vec4(max(a.x, -WFV_PI), a.y, min(a.z, WFV_PI), a.w), front);
  if (a.z > WFV_PI)
  {
    wfvEmitRectangle(vec4(-WFV_PI, a.y, a.z - turn, a.w), front);
  }
  else if (a.x < -WFV_PI)
  {
    wfvEmitRectangle(vec4(a.x + turn, a.y, WFV_PI, a.w), front);
  }
}
