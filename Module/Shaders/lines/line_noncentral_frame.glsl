// SPDX-License-Identifier: BSD-3-Clause
// Lines, geometry stage, of an eye whose rays begin on a circle: the frame of line_noncentral.glsl from the
// two ends of the line, and what of it no ray sees.

// Part of the line's or the circle's distance that the frame's is at the least.
const float WFV_NC_LEAST = 0.1;

// Steps of a search by halves for float32.
const int WFV_NC_CUTS = 26;

bool wfvLevel = false; // see line_frame.glsl: false, for angles are looked at all along
bool wfvNcAxial = false; // the axis of the circle is near
bool wfvNcMapped = false; // the axis of the map counts
bool wfvNcWindow = false; // nothing less than the window surely holds it

float wfvNcRadius()
{
  return wfvFromMiddle(wfvView) / wfvScale();
}

float wfvFromAxis(vec3 p)
{
  vec3 up = wfvUpright(wfvView);
  return length(p - up * dot(p, up));
}

// Turns the frame so that the point at this angle becomes its top.
void wfvTurnFrame(float to)
{
  vec3 top = wfvNcAhead(to);
  wfvArcSide = cos(to) * wfvArcSide - sin(to) * wfvArcTop;
  wfvArcTop = top;
  wfvArcEnds.xy -= to;
  wfvArcRange -= to;
  wfvArcFoot -= to;
  vec2 turned = wfvHasGap() ? vec2(to) : vec2(0.0);
  wfvArcGap -= turned;
  wfvArcInner -= turned;
  wfvSetLine();
}

vec3 wfvNcPlace(float a)
{
  return wfvNcAhead(a) * (wfvArcDistance / max(cos(a - wfvArcFoot), WFV_NC_END));
}

// The frame whose top is the foot.
void wfvFrameNc(vec3 p, vec3 q)
{
  vec3 d = q - p;
  float l = length(d);
  vec3 u = l > 0.0 ? d / l : normalize(cross(p, abs(p.x) < abs(p.y) ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 1.0, 0.0)));
  bool first = dot(p, p) < dot(q, q);
  float along = dot(first ? p : q, u);
  vec3 foot = (first ? p : q) - along * u;
  vec2 x = first ? vec2(along, along + l) : vec2(along - l, along);
  float from = length(foot);
  float r = wfvNcRadius();
  float distance_ = sqrt(abs((from - r) * (from + r)));
  wfvArcDistance = max(max(distance_, WFV_NC_LEAST * max(from, r)), 1e-6 * length(p) + 1e-12);
  wfvArcTop = foot / wfvArcDistance;
  wfvArcSide = u;
  wfvArcFoot = 0.0;
  vec2 far = sqrt(x * x + wfvArcDistance * wfvArcDistance);
  wfvArcEnds = vec4(wfvAtan2(x.x, wfvArcDistance), wfvAtan2(x.y, wfvArcDistance), far);
  wfvArcRange = wfvArcEnds.xy;
  wfvArcDelta = 1.0;
  wfvArcCut = WFV_NO_CUT;
  wfvArcJump = false;
  wfvArcGap = vec2(WFV_NO_CUT);
  wfvArcInner = wfvArcGap;
  wfvTwoTops = false;
  wfvNcMapped = true;
  wfvLevel = false;
  wfvTurnFrame(0.5 * (wfvArcEnds.x + wfvArcEnds.y));
}

// The angle at which the line passes the axis of the circle.
float wfvAngleAtAxis()
{
  vec3 up = wfvUpright(wfvView);
  vec3 u = cos(wfvArcFoot) * wfvArcSide - sin(wfvArcFoot) * wfvArcTop;
  vec3 foot = wfvNcPlace(wfvArcFoot);
  vec3 level = u - up * dot(u, up);
  float x = -dot(foot, level) / max(dot(level, level), 1e-20);
  return clamp(wfvArcFoot + wfvAtan2(x, wfvArcDistance), wfvArcEnds.x, wfvArcEnds.y);
}

bool wfvIsSeen(float a)
{
  return wfvSee(wfvNcPlace(a) * wfvScale(), wfvView).seen;
}

float wfvGapEnd(float seen, float unseen)
{
  for (int i = 0; i < WFV_NC_CUTS; i++)
  {
    float a = 0.5 * (seen + unseen);
    bool is = wfvIsSeen(a);
    seen = is ? a : seen;
    unseen = is ? unseen : a;
  }
  return seen;
}

// The angles between which the line is nearer to the axis than the circle; at: where it is nearest.
vec2 wfvFindGap(float at)
{
  if (wfvFades(wfvView))
  {
    vec2 ends = wfvArcEnds.xy;
    return vec2(wfvIsSeen(ends.x) ? wfvGapEnd(ends.x, at) : ends.x,
      wfvIsSeen(ends.y) ? wfvGapEnd(ends.y, at) : ends.y);
  }
  vec3 up = wfvUpright(wfvView);
  vec3 level = wfvNcAlong - up * dot(wfvNcAlong, up);
  vec3 foot = wfvNcPlace(wfvArcFoot);
  foot -= up * dot(foot, up);
  float l2 = max(dot(level, level), 1e-20);
  float x = -dot(foot, level) / l2;
  float aside = length(foot + x * level);
  float r = wfvNcRadius();
  float half_ = sqrt(max((r - aside) * (r + aside), 0.0) / l2);
  return wfvArcFoot +
    vec2(wfvAtan2(x - half_, wfvArcDistance), wfvAtan2(x + half_, wfvArcDistance));
}
