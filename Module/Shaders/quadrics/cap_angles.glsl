// SPDX-License-Identifier: BSD-3-Clause
// Covers a cap in maps of angles: it becomes a rectangle of angles, and that a rectangle of the map
// (wfvBounds), in two parts where it reaches across the seam.

// A rectangle of angles whose azimuth may extend across the seam.
void wfvEmitAngles(vec4 a, bool front)
{
#if WFV_MERIDIAN
  float turn = 2.0 * WFV_PI;
  wfvEmitBox(wfvBounds(vec4(max(a.x, -WFV_PI), a.y, min(a.z, WFV_PI), a.w), wfvView), front);
  if (a.z > WFV_PI)
  {
    wfvEmitBox(wfvBounds(vec4(-WFV_PI, a.y, a.z - turn, a.w), wfvView), front);
  }
  else if (a.x < -WFV_PI)
  {
    wfvEmitBox(wfvBounds(vec4(a.x + turn, a.y, WFV_PI, a.w), wfvView), front);
  }
#else
  wfvEmitBox(wfvBounds(a, wfvView), front);
#endif
}

// Sine of the angle between a direction and the poles of the family.
float wfvPoleSine(vec3 p)
{
#if WFV_MERIDIAN
  return wfvHypot(p.x, p.z) / wfvLength(p);
#else
  return wfvHypot(p.x, p.y) / wfvLength(p);
#endif
}

// The range of the polar angle (latitude, or theta) of the whole family.
vec2 wfvPolarRange()
{
#if WFV_MERIDIAN
  return vec2(-0.5 * WFV_PI, 0.5 * WFV_PI);
#else
  return vec2(0.0, WFV_PI);
#endif
}

void wfvCoverCap(vec3 centre, float angle, bool front)
{
  float radius = angle + WFV_CAP_PAD;
  if (!(radius < 0.5 * WFV_PI) || !(wfvLength(centre) > 0.0))
  {
    wfvEmitWindow(front);
    return;
  }
  vec2 a = WFV_ANGLES(centre);
  vec2 all = wfvPolarRange();
  float low = a.y - radius;
  float high = a.y + radius;
  // where the cap holds a pole it has every azimuth; else its edge meets the farthest
  // meridian at a right angle
  float s = (1.0 + WFV_CAP_SLACK) * sin(radius) / max(wfvPoleSine(centre), 1e-30);
  bool pole = low <= all.x || high >= all.y || s >= 1.0;
  float across = pole ? WFV_PI : wfvAtan2(s, sqrt((1.0 - s) * (1.0 + s))) + WFV_CAP_PAD;
#if WFV_MERIDIAN
  a.x = pole ? 0.0 : a.x;
#else
  all.y = min(all.y, wfvView.maxAngle);
#endif
  low = max(low, all.x);
  high = min(high, all.y);
  if (low <= high)
  {
    wfvEmitAngles(vec4(a.x - across, low, a.x + across, high), front);
  }
}
