// SPDX-License-Identifier: BSD-3-Clause
// Debug view: the colour of this fragment before light falls on it.

// Of the colour, how much light leaves as it is: shapes stay readable, colours too.
const float WFV_DEBUG_AMBIENT = 0.6;

// Pixels: triangles narrower than this show no edges, which would be all there is to see;
// from twice as many on they show them fully.
const float WFV_DEBUG_SMALL = 6.0;

vec3 wfvDebugColor()
{
#if WFV_DEBUG_TRIANGLES
  vec3 d = wfvEdgePixels;
  vec3 heights = d / max(abs(wfvB), vec3(1e-6));
  float height = min(heights.x, min(heights.y, heights.z));
  float thin = clamp(1.2 - min(d.x, min(d.y, d.z)), 0.0, 1.0);
  float large = clamp(height / WFV_DEBUG_SMALL - 1.0, 0.0, 1.0);
  return wfvKindColor(wfvMode / WFV_KIND_UNIT) * (1.0 - 0.6 * thin * large);
#else
  return wfvKindColor(WFV_DEBUG_KIND);
#endif
}
