// SPDX-License-Identifier: BSD-3-Clause
// Fragment side of the pre-clip: barycentric coordinates, coverage and depth of the
// primitive at this pixel, before the stock shader runs.

in vec3 wfvBary;
in vec3 wfvPosition;
flat in vec3 wfvEdge0;
flat in vec3 wfvEdge1;
flat in vec3 wfvEdge2;
flat in vec4 wfvPlane;
flat in vec3 wfvSlack;
flat in int wfvMode;

vec3 wfvB;       // barycentric coordinates here
float wfvDepth;  // window depth here, 0 to 1
bool wfvHide;    // not covered: discarded once the stock shader has run
bool wfvFront;   // seen from its front

#if WFV_EDGES
vec3 wfvEdgePixels; // distance in pixels to the edge opposite to corner 0, 1, 2
#endif

void wfvInterpolate(); // generated: sets the stock shader's inputs from wfvB

vec2 wfvSample = vec2(0.0); // looked at, pixels from the centre

// chord_fragment.glsl
vec3 wfvChordReach();
vec3 wfvToChords(vec3 e, vec3 dx, vec3 dy);
bool wfvAllInside(vec3 e, vec3 toChords);

// Positive inside.
vec3 wfvEdgesAt(vec3 direction)
{
  vec3 e = vec3(dot(direction, wfvEdge0), dot(direction, wfvEdge1), dot(direction, wfvEdge2));
  return wfvPlane.w > 0.0 ? e : -e;
}

// Pixels: no sample is farther from its pixel's centre along either axis.
const float WFV_SAMPLE_REACH = 0.5;

// Safety over first-order bounds of what changes inside a pixel.
const float WFV_PIXEL_SAFETY = 1.5;

// Coverage by the ray of the pixel's centre, or by the ray of each sample. e: the edge
// functions at the centre; pixel: how the direction changes along x and y.
bool wfvCoverage(WfvRay ray, vec3 e, mat2x3 pixel, bool rim)
{
  vec3 x = wfvEdgesAt(pixel[0]);
  vec3 y = wfvEdgesAt(pixel[1]);
  vec3 toChords = wfvToChords(e, x, y);
  if (wfvSamples <= 1)
  {
    return wfvAllInside(e, toChords) && ray.inside;
  }
  vec3 reach = WFV_PIXEL_SAFETY * (WFV_SAMPLE_REACH + wfvChordReach()) * (abs(x) + abs(y));
  bool certain = !rim && all(greaterThan(abs(e), reach));
  int mask = certain && all(greaterThan(e, vec3(0.0))) ? -1 : 0;
  for (int i = 0; i < wfvSamples && !certain; i++)
  {
    WfvRay at = wfvRayAt(wfvSampleOffsets[i]);
    wfvSample = wfvSampleOffsets[i];
    vec3 there = wfvEdgesAt(at.direction);
    mask |= at.inside && wfvAllInside(there, wfvToChords(there, x, y)) ? 1 << i : 0;
  }
#ifdef GL_ARB_sample_shading
  gl_SampleMask[0] = mask;
#endif
  return mask != 0;
}

// Window depth of a distance from the eye in the stage's own units; interpolated depth
// would err along edges that run away from the eye.
float wfvWindowDepth(float rho)
{
  return wfvDepthOf(rho * wfvScale(), wfvView);
}

bool wfvCovered()
{
  WfvRay ray = wfvRayAt(vec2(0.0));
  bool rim;
  mat2x3 pixel = wfvRaySteps(ray, rim);
  vec3 e = wfvEdgesAt(ray.direction);
  float facing = wfvPlane.w > 0.0 ? 1.0 : -1.0;
  float sum = facing * dot(ray.direction, wfvPlane.xyz);
  wfvB = e / (e.x + e.y + e.z);
  wfvDepth = wfvWindowDepth(facing * wfvPlane.w / sum);
  return wfvCoverage(ray, e, pixel, rim) && sum > 0.0;
}

void wfvPrepare()
{
#ifdef GL_ARB_sample_shading
  gl_SampleMask[0] = -1;
#endif
  wfvB = wfvBary / (wfvBary.x + wfvBary.y + wfvBary.z);
  wfvDepth = wfvWindowDepth(length(wfvPosition));
  wfvFront = (wfvMode & 1) == 0 ? gl_FrontFacing : wfvPlane.w < 0.0;
  bool covered = (wfvMode & 1) == 0 || wfvCovered();
  covered = covered && wfvDepth >= 0.0 && wfvDepth <= 1.0;
#if WFV_EDGES
  vec3 slope = vec3(length(vec2(dFdx(wfvB.x), dFdy(wfvB.x))),
    length(vec2(dFdx(wfvB.y), dFdy(wfvB.y))), length(vec2(dFdx(wfvB.z), dFdy(wfvB.z))));
  wfvEdgePixels = abs(wfvB) / max(slope, vec3(1e-12));
#endif
  wfvInterpolate();
  wfvHide = !covered;
}
