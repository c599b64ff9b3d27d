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

// Where a sample lies inside a pixel, from its centre, pixels; one sample: the centre.
uniform int wfvSamples;
uniform vec2 wfvSampleOffsets[16];

// chord_fragment.glsl
vec3 wfvToChords(vec3 e, vec3 dx, vec3 dy);
bool wfvAllInside(vec3 e, vec3 toChords);

// Coverage by the ray: of the pixel's centre, or of each sample, to which the edge
// functions are carried on along their slopes (the same from both sides of an edge).
bool wfvCoverage(vec3 e)
{
  vec3 dx = dFdx(e);
  vec3 dy = dFdy(e);
  vec3 toChords = wfvToChords(e, dx, dy);
  if (wfvSamples <= 1)
  {
    return wfvAllInside(e, toChords);
  }
  int mask = 0;
  for (int i = 0; i < wfvSamples; i++)
  {
    vec3 at = e + dx * wfvSampleOffsets[i].x + dy * wfvSampleOffsets[i].y;
    mask |= wfvAllInside(at, toChords) ? 1 << i : 0;
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
  return (rho * wfvScale() - wfvView.radii.x) / (wfvView.radii.y - wfvView.radii.x);
}

bool wfvCovered()
{
  vec2 ndc = 2.0 * (gl_FragCoord.xy - wfvViewport.xy) / wfvViewport.zw - 1.0;
  WfvRay ray = wfvUnproject((ndc - wfvTile.zw) / wfvTile.xy, wfvView);
  vec3 e = vec3(dot(ray.direction, wfvEdge0), dot(ray.direction, wfvEdge1),
    dot(ray.direction, wfvEdge2));
  float facing = wfvPlane.w > 0.0 ? 1.0 : -1.0;
  float sum = dot(ray.direction, wfvPlane.xyz);
  wfvB = e / (e.x + e.y + e.z);
  wfvDepth = wfvWindowDepth(wfvPlane.w / sum);
  bool inside = wfvCoverage(facing * e);
  return inside && ray.inside && facing * sum > 0.0;
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
