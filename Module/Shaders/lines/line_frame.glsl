// SPDX-License-Identifier: BSD-3-Clause
// Lines, geometry stage: the frame of the arc of line_arc.glsl from the two ends of the line,
// and where its image is discontinuous.

// Sine below which float32 cannot tell an arc's plane: a line towards or through the eye.
const float WFV_RADIAL = 4e-7;

// Sine of the distance from the axis of the plane's normal above which an arc has no top.
const float WFV_LEVEL = 0.9999;

// Radians: latitudes of such arcs, rounded up; sqrt(2 (1 - WFV_LEVEL)).
const float WFV_LEVEL_PAD = 0.015;

bool wfvLevel = false; // the arc keeps to its latitude

// Angle at which the arc crosses a seam that is not straight, or WFV_NO_CUT.
float wfvSeamAngle()
{
#if WFV_MERIDIAN && !WFV_STRAIGHT_SEAM
  for (float s = -1.0; s < 2.0; s += 2.0)
  {
    // where x is 0: one of the two lies behind the eye
    float a = wfvAtan2(-s * wfvArcTop.x, s * wfvArcSide.x);
    a = wfvNearestTurn(a, 0.5 * (wfvArcRange.x + wfvArcRange.y));
    if (a > wfvArcRange.x && a < wfvArcRange.y && wfvArcAt(a).z > 0.0)
    {
      return a;
    }
  }
#endif
  return WFV_NO_CUT;
}

// The frame of the arc from its middle; false where the line points at the eye.
bool wfvFrameArc(vec3 p, vec3 q)
{
  float l0 = length(p);
  float l1 = length(q);
  vec3 d = q - p;
  vec3 u = l0 > 0.0 ? p / l0 : q / l1;
  vec3 base = length(d) < l1 ? d : q;
  vec3 v = base - u * dot(u, base);
  float s = length(v);
  float c = l0 + dot(u, d);
  float span = wfvAtan2(s, c);
  bool plane = s > WFV_RADIAL * length(base) && l0 > 0.0;
  v = plane ? v / s : normalize(cross(u, abs(u.x) < 0.5 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 1.0, 0.0)));
  v = normalize(v - u * dot(u, v));
  span = plane ? span : (c < 0.0 && l0 > 0.0 ? WFV_PI : 0.0);
  wfvArcTop = cos(0.5 * span) * u + sin(0.5 * span) * v;
  wfvArcSide = cos(0.5 * span) * v - sin(0.5 * span) * u;
  wfvArcEnds = vec4(-0.5 * span, 0.5 * span, l0, l1);
  wfvArcRange = wfvArcEnds.xy;
  wfvArcDelta = 1.0;
  wfvArcCut = WFV_NO_CUT;
  wfvArcJump = false;
  return plane;
}

// Turns the frame of the arc to its point nearest to the axis.
void wfvFrameTop()
{
  vec3 n = cross(wfvArcTop, wfvArcSide);
#if WFV_MERIDIAN
  float s = n.y;
  vec3 top = vec3(0.0, 1.0, 0.0) - s * n;
#else
  float s = n.z;
  vec3 top = vec3(0.0, 0.0, 1.0) - s * n;
#endif
  if (abs(s) < WFV_LEVEL)
  {
    top = normalize(top);
    // of the two, a half turn apart, the one nearer to the middle of the arc
    top = dot(top, wfvArcTop) < 0.0 ? -top : top;
    vec3 side = normalize(cross(n, top));
    float turn = wfvAtan2(dot(wfvArcTop, side), dot(wfvArcTop, top));
    wfvArcTop = top;
    wfvArcSide = side;
    wfvArcEnds = vec4(wfvArcEnds.xy + turn, wfvArcEnds.zw);
    wfvArcRange += turn;
  }
  bool inside = wfvArcRange.x < 0.0 && wfvArcRange.y > 0.0;
  wfvLevel = abs(s) >= WFV_LEVEL;
  wfvArcJump = abs(s) <= WFV_LEAST_DELTA;
#if !WFV_MERIDIAN
  wfvArcJump = wfvArcJump && wfvArcTop.z > 0.0; // the centre of the map is no pole
#endif
  wfvArcDelta = wfvArcJump ? 1.0 : clamp(abs(s), WFV_LEAST_DELTA, 1.0);
  wfvArcCut = wfvArcJump && inside ? 0.0 : WFV_NO_CUT;
}
