// SPDX-License-Identifier: BSD-3-Clause
// Fragment side of the pre-clip: which samples of the pixel the triangle covers.

// Pixels: no sample is farther from its pixel's centre along either axis.
const float WFV_SAMPLE_RADIUS = 0.5;

// Safety over first-order bounds of what changes inside a pixel.
const float WFV_PIXEL_SAFETY = 1.5;

// Software rendering runs through both sides of every branch and through each loop once, so
// what a draw cannot need is left out of its shader: samples and chords.
#if WFV_EXACT
const bool wfvByChord = false;
#else
bool wfvByChord = false; // drawn with chords: a chord decides which pixels are covered
#endif

#if WFV_MULTISAMPLE
// By which ray the fragment has its depth and its attributes: the centre's, or that of a sample
// where the centre is not covered. A face seen nearly edge-on, continued to there, would come out
// before the one that hides it.
vec3 wfvShown = vec3(0.0);

// Coverage by the ray of each sample, or by that of the pixel's centre where all samples
// agree with it. e: the edge functions there; x, y: how they change from pixel to pixel.
bool wfvCoverage(WfvRay ray, vec3 e, vec3 x, vec3 y, bool rim)
{
  vec3 margin = WFV_PIXEL_SAFETY * (WFV_SAMPLE_RADIUS + wfvChordErrors()) * (abs(x) + abs(y));
#if WFV_NON_CENTRAL
  rim = rim || wfvTurns(ray.direction);
#elif WFV_CURVED_RAYS
  rim = true; // every sample has a depth of its own
#endif
  bool certain = wfvByChord || (!rim && all(greaterThan(abs(e), margin)));
  int mask = wfvByChord || (certain && all(greaterThan(e, vec3(0.0)))) ? -1 : 0;
  bool centre = certain || (ray.inside && wfvAllInside(e, wfvToChords(ray.direction, e, x, y)));
  // without samples, in a shader that still reckons with several, the centre decides
  mask = wfvSamples <= 1 && centre && !certain ? -1 : mask;
  wfvShown = ray.direction;
  for (int i = 0; i < wfvSamples && !certain; i++)
  {
    WfvRay at = wfvSurfaceRay(wfvSampleOffsets[i]);
    wfvSample = wfvSampleOffsets[i];
    vec3 there = vec3(wfvEdgesAt(at.direction));
    bool covered = at.inside && wfvAllInside(there, wfvToChords(at.direction, there, x, y));
    mask |= covered ? 1 << i : 0;
    wfvShown = covered && !centre ? at.direction : wfvShown;
  }
#ifdef GL_ARB_sample_shading
  gl_SampleMask[0] = mask;
#endif
  return mask != 0;
}
#else
bool wfvCoverage(WfvRay ray, vec3 e, vec3 x, vec3 y, bool rim)
{
  return wfvByChord || (wfvAllInside(e, wfvToChords(ray.direction, e, x, y)) && ray.inside);
}
#endif
