// SPDX-License-Identifier: BSD-3-Clause
// What every stage of a wide view shares; set by vtkWideFoVStage.

uniform WfvView wfvView;
uniform vec4 wfvViewport;  // x, y, width, height of the viewport, pixels
// NDC is the map's own: that of the picture, but for a round map whose axis is not in the middle
// (wfvView.center).
uniform vec4 wfvTile;      // NDC of the tile = NDC * xy + zw

uniform vec4 wfvPicture;   // pixels: of NDC -1, -1, in the window; size of the picture

// NDC at a place in pixels of the window. Rounded once: at a rim where a map is
// flat these digits are all there is, and they are the same in a tile as in the whole picture.
vec2 wfvNdcOfPixel(vec2 at)
{
  vec2 twice = 2.0 * (at - wfvPicture.xy) - wfvPicture.zw;
  return twice / wfvPicture.zw;
}

// Position in the map as a clip coordinate. Dividing by the distance to the eye makes
// the interpolation of attributes perspective-correct. Clipped by linear depth whatever
// the mapping, which the fragment stage applies.
vec4 wfvClip(vec2 ndc, float rho)
{
  float depth = 2.0 * wfvLinearDepth(rho, wfvView) - 1.0;
#if WFV_SHIFTED
  ndc = wfvShift(ndc, clamp(2.0 * wfvDepthOf(rho, wfvView) - 1.0, -1.0, 1.0), wfvView);
#endif
  return vec4((ndc * wfvTile.xy + wfvTile.zw) * rho, depth * rho, rho);
}

// View coordinates per unit of the pre-clip's own: a power of two near the far radius or below, which
// costs no rounding.
uniform float wfvUnit;

float wfvScale()
{
  return wfvUnit;
}

#if WFV_NON_CENTRAL
// Where the eye sees a point of the stage's own units, as if it were the origin.
vec3 wfvSeenPlace(vec3 p)
{
  WfvRayHit s = wfvSee(p * wfvScale(), wfvView);
  return s.direction * (s.distance / wfvScale());
}
#endif

// Linear depth is x times the distance in those units, plus y.
uniform vec2 wfvUnitDepth;

float wfvDepthInUnits(float rho)
{
  return WFV_DEPTH_MAPPING(wfvView) == WFV_DEPTH_LINEAR ? wfvUnitDepth.x * rho + wfvUnitDepth.y
                                                        : wfvDepthOf(rho * wfvScale(), wfvView);
}

// Begun as the map begins, so that a compiler takes what both need from one computation.
float wfvLength(vec3 p)
{
#if WFV_MERIDIAN
  return wfvHypot(wfvHypot(p.x, p.z), p.y);
#else
  return wfvHypot(wfvHypot(p.x, p.y), p.z);
#endif
}

// The same without a root: 1 to 1.74 of it.
float wfvTaxiLength(vec3 p)
{
  return abs(p.x) + abs(p.y) + abs(p.z);
}

// View coordinates, as the stock vertex stage leaves them, to clip coordinates.
vec4 wfvProjectVertex(vec3 p)
{
  vec3 q = wfvTilt(p, wfvView);
  float rho = wfvLength(q);
  // the eye itself has no place in the map: in front of the near sphere, clipped
  return rho > 0.0 ? wfvClip(wfvProject(q, wfvView), rho) : vec4(0.0, 0.0, -2.0, 1.0);
}
