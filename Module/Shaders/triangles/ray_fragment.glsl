// SPDX-License-Identifier: BSD-3-Clause
// The rays of a fragment: of its centre and of its samples.

// Where a sample lies inside a pixel, from its centre, pixels; one sample: the centre.
uniform int wfvSamples;
uniform vec2 wfvSampleOffsets[WFV_MOST_SAMPLES];

// NDC of the place so many pixels beside the centre of the fragment.
vec2 wfvPlaceBeside(vec2 offset)
{
  return wfvNdcOfPixel(gl_FragCoord.xy + offset);
}

// The picture's centre, pixels of the window, and the raw map's units a pixel.
uniform vec4 wfvPixelToMap;

// Its ray.
WfvRay wfvRayAt(vec2 offset)
{
#if WFV_FLAT_RIM
  return wfvUnproject(wfvPlaceBeside(offset), wfvView);
#else
  vec2 p = gl_FragCoord.xy + offset - wfvPixelToMap.xy;
  vec2 m = p * wfvPixelToMap.zw;
  WfvRay ray = wfvRayOfMap(m, wfvView);
#if WFV_MERIDIAN && WFV_STRAIGHT_SEAM
  ray.direction = wfvCylinderDirection(p, m);
#endif
  return ray;
#endif
}

#if WFV_FACES
// The face of a cube that the picture shows there.
int wfvFaceBeside(vec2 offset)
{
  return wfvFaceAt(wfvPlaceBeside(offset) / wfvView.scale);
}
#endif
