// SPDX-License-Identifier: BSD-3-Clause
// Covers a triangle for round maps: a ring sector in four pieces, whose chords lie
// outside the outer circle and inside the inner one.

void wfvCover(bool front)
{
  const int pieces = 4;
  bool centre = wfvHolds(2, -1.0);
  bool antipode = wfvHolds(2, 1.0);
  vec4 a = wfvAngularBounds(vec3(0.0, 0.0, 1.0));
#if WFV_NON_CENTRAL
  a = wfvGrowAngles(a, min(a.y, WFV_PI - a.w));
#endif
  a = vec4(a.x, centre ? 0.0 : max(a.y, 0.0), a.z, antipode ? WFV_PI : a.w);
  a.w = min(a.w, min(WFV_PI, wfvView.maxAngle + WFV_ANGLE_PAD));
  if (a.y > a.w)
  {
    return;
  }
  vec2 size = 0.5 * wfvViewport.zw * wfvTile.xy;
  float pixels = min(size.x * wfvView.scale.x, size.y * wfvView.scale.y);
  float inner = max(0.0, wfvRadius(a.y, wfvView) - WFV_PAD / pixels);
  float outer = wfvRadius(a.w, wfvView) + WFV_PAD / pixels;
  float pad = WFV_PAD / max(inner * pixels, 1e-6);
  bool corner = wfvCornerAtPole(vec3(0.0, 0.0, 1.0));
  bool whole = ((centre || antipode) && !corner) || pad > 0.5 || a.z - a.x + 2.0 * pad >= 2.0 * WFV_PI;
  float u0 = whole ? -WFV_PI : a.x - pad;
  float du = (whole ? 2.0 * WFV_PI : a.z - a.x + 2.0 * pad) / float(pieces);
  outer = outer / cos(0.5 * du);
  for (int i = 0; i <= pieces; i++)
  {
    float u = u0 + du * float(i);
    vec2 d = vec2(cos(u), sin(u)) * wfvView.scale;
    vec2 first = d * (front ? inner : outer);
    vec2 second = d * (front ? outer : inner);
    wfvEmit(vec4(first * wfvTile.xy + wfvTile.zw, 0.0, 1.0), vec3(0.0));
    wfvEmit(vec4(second * wfvTile.xy + wfvTile.zw, 0.0, 1.0), vec3(0.0));
  }
  wfvEnd();
}
