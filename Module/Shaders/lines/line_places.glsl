// SPDX-License-Identifier: BSD-3-Clause
// Lines as chords, geometry stage: the stretch of a line that is drawn at a time, and the places of its
// points in the picture.

uniform float wfvLineWidth; // pixels

// Cosine: how far beyond its rim a round map is asked.
const float WFV_BEYOND_RIM = 1e-3;

// What is drawn at a time: a stretch of the line, counted from the end nearer to the axis of the map,
// where float32 is finest then.
vec3 wfvBegin = vec3(0.0);
vec3 wfvWay = vec3(0.0);
bool wfvBackwards = false; // drawn from its other end on: by the hardware's rule a line lacks its last pixel
vec2 wfvLengths = vec2(0.0); // distances of the two from the eye
vec2 wfvShares = vec2(0.0);  // and their shares of the line
float wfvSide = 0.0;         // of the seam that it lies on; 0: it does not
float wfvTurned = 0.0;       // clip coordinates by which it is drawn beside its place: the period of a map, or 0

// A point of it.
struct WfvPlace
{
  vec4 clip; // w: 0 where the map does not show it
  vec3 seen; // where the eye sees it
  float way; // share of the way to it
};

// Share of the straight way at an equal step s, 0 to 1, in a picture.
float wfvStep(float s, float first, float last)
{
  return s * first / (s * first + (1.0 - s) * last);
}

bool wfvIsShown(vec3 p, float rho)
{
#if WFV_ROUND
  return -p.z >= (cos(wfvView.maxAngle) - WFV_BEYOND_RIM) * rho;
#elif WFV_FACES || WFV_MERIDIAN
  return true;
#elif WFV_SAMPLED
  vec2 ndc = wfvProject(p, wfvView);
  return max(abs(ndc.x), abs(ndc.y)) <= 1.0;
#else
  return -p.z > WFV_BEYOND_RIM * rho;
#endif
}

WfvPlace wfvPlaceAt(float way)
{
  WfvPlace place;
  place.way = way;
  vec3 p = wfvBegin + way * wfvWay;
#if WFV_NON_CENTRAL
  WfvRayHit hit = wfvSee(p * wfvScale(), wfvView);
  p = hit.seen ? hit.direction * (hit.distance / wfvScale()) : vec3(0.0);
#endif
  float rho = wfvLength(p);
  place.seen = p;
  place.clip = vec4(0.0);
  if (rho > 0.0 && wfvIsShown(p, rho))
  {
    place.clip = wfvClipOnSide(p, wfvSide);
    place.clip.x += wfvTurned * place.clip.w;
  }
  return place;
}

// The end of a piece, at a share of the stretch in equal steps of a picture.
WfvPlace wfvEndAt(float s)
{
  s = wfvBackwards ? 1.0 - s : s;
  return wfvPlaceAt(wfvStep(s, wfvLengths.x, wfvLengths.y));
}

// What the rasterizer shows at a share of the chord from one place to another.
WfvPlace wfvBetween(WfvPlace from, WfvPlace to, float share)
{
  float step_ = wfvStep(share, max(wfvLength(from.seen), 1e-30), max(wfvLength(to.seen), 1e-30));
  return wfvPlaceAt(mix(from.way, to.way, step_));
}

// Pixels from the middle of the tile.
vec2 wfvPixelOf(WfvPlace place)
{
  return 0.5 * wfvViewport.zw * place.clip.xy / max(place.clip.w, 1e-30);
}
