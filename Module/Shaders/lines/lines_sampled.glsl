// SPDX-License-Identifier: BSD-3-Clause
// Pre-clip of lines on a direction map: pieces, each of which is drawn where both its ends
// and its middle are shown, and the middle between the ends. Others meet a discontinuity, and are left out.

// Part of a piece's length, and pixels, by which its middle may lie beside the middle of its
// ends; at a discontinuity it lies at one end.
const float WFV_GAP_PIECE = 0.25;
const float WFV_GAP_PIXELS = 2.0;

bool wfvIsContinuous(vec4 a, vec4 m, vec4 b)
{
  vec2 half_ = 0.5 * wfvViewport.zw;
  vec2 chord = half_ * (b.xy / b.w - a.xy / a.w);
  vec2 off = half_ * (m.xy / m.w - 0.5 * (a.xy / a.w + b.xy / b.w));
  return length(off) <= WFV_GAP_PIECE * length(chord) + WFV_GAP_PIXELS;
}

bool wfvIsShown(vec3 p)
{
  vec2 ndc = wfvProject(p, wfvView);
  return abs(ndc.x) <= 1.0 && abs(ndc.y) <= 1.0;
}

void wfvEmitSampled()
{
  float la = length(wfvP[0]);
  float lb = length(wfvP[1]);
  float t = 0.0;
  for (int i = 0; i < WFV_MAX_PIECES; i++)
  {
    float middle = wfvStep((float(i) + 0.5) / float(WFV_MAX_PIECES), la, lb);
    float next = i + 1 < WFV_MAX_PIECES ? wfvStep(float(i + 1) / float(WFV_MAX_PIECES), la, lb) : 1.0;
    vec3 p = mix(wfvP[0], wfvP[1], t);
    vec3 m = mix(wfvP[0], wfvP[1], middle);
    vec3 q = mix(wfvP[0], wfvP[1], next);
    vec4 a = wfvClipOnSide(p, 0.0);
    vec4 b = wfvClipOnSide(q, 0.0);
    if (wfvIsShown(p) && wfvIsShown(m) && wfvIsShown(q) && wfvIsContinuous(a, wfvClipOnSide(m, 0.0), b))
    {
#if WFV_WIDE_LINES
      wfvEmitAcross(a, a, b, t);
      wfvEmitAcross(b, a, b, next);
#else
      wfvEmitPoint(a, t);
      wfvEmitPoint(b, next);
#endif
      EndPrimitive();
    }
    t = next;
  }
}
