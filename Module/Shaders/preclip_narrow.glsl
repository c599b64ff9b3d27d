// SPDX-License-Identifier: BSD-3-Clause
// Covers a triangle, whose edges stay near their chords, with little more than its own
// picture: hardly more pixels than its chords would draw, though each is decided by its ray.

uniform int wfvSamples; // of the fragment stage; one: pixel centres alone are looked at

// Pixels added all round: a corner's place in float32 errs by 0.02 in a picture 8192 wide
// (Agreement of GpuMathTest.cxx), and rasterizers snap corners by up to 1/128.
const float WFV_TIGHT_PAD = 0.0625;

// Factor on the sampled distance of the edges from their chords, and pixels added to it, for
// what lies between the samples.
const float WFV_REACH_SAFETY = 1.5;
const float WFV_REACH_PAD = 0.5;

// True where no pixel centre lies between two places, in pixels from the tile's centre.
bool wfvBetweenCentres(vec2 low, vec2 high)
{
  vec2 first = ceil(low + 0.5 * wfvViewport.zw - 0.5);
  vec2 last = floor(high + 0.5 * wfvViewport.zw - 0.5);
  return WFV_WARPED == 0 && wfvSamples <= 1 && (first.x > last.x || first.y > last.y);
}

vec2 wfvShape[4]; // pixels of the tile, from its centre

// A rectangle along the longest chord, grown by so many pixels: narrower than one along the
// axes for what lies askew. From the corners wfvC.
void wfvShapeAlong(float grow, bool front)
{
  vec2 along = wfvC[1] - wfvC[0];
  along = length(wfvC[2] - wfvC[1]) > length(along) ? wfvC[2] - wfvC[1] : along;
  along = length(wfvC[0] - wfvC[2]) > length(along) ? wfvC[0] - wfvC[2] : along;
  float l = length(along);
  along = l > 1e-6 ? along / l : vec2(1.0, 0.0);
  vec2 across = vec2(-along.y, along.x);
  vec2 low = vec2(1e9);
  vec2 high = vec2(-1e9);
  for (int i = 0; i < 3; i++)
  {
    vec2 at = vec2(dot(wfvC[i], along), dot(wfvC[i], across));
    low = min(low, at - grow);
    high = max(high, at + grow);
  }
  vec2 right = along * (high.x - low.x);
  vec2 up = across * (high.y - low.y);
  wfvShape[0] = along * low.x + across * low.y;
  wfvShape[1] = wfvShape[0] + (front ? right : up);
  wfvShape[2] = wfvShape[0] + (front ? up : right);
  wfvShape[3] = wfvShape[0] + right + up;
}

// grow: pixels to move the sides out by. Grown from the centre of its inscribed circle, the
// sides of a triangle move out evenly; a needle would grow far beyond its ends, and takes the
// rectangle along its longest side, as everything does that is smaller so.
void wfvCoverTight(float grow, bool front)
{
  for (int i = 0; i < 3; i++)
  {
    wfvC[i] = wfvPixel(wfvP[i]);
  }
  if (wfvBetweenCentres(min(wfvC[0], min(wfvC[1], wfvC[2])) - grow,
        max(wfvC[0], max(wfvC[1], wfvC[2])) + grow))
  {
    return;
  }
  vec3 sides = vec3(length(wfvC[2] - wfvC[1]), length(wfvC[0] - wfvC[2]), length(wfvC[1] - wfvC[0]));
  float sum = sides.x + sides.y + sides.z;
  vec2 centre = (sides.x * wfvC[0] + sides.y * wfvC[1] + sides.z * wfvC[2]) / sum;
  vec2 a = wfvC[1] - wfvC[0];
  vec2 b = wfvC[2] - wfvC[0];
  float twice = a.x * b.y - a.y * b.x;
  float times = grow * sum / abs(twice); // grow, in radii of the inscribed circle
  float longest = max(sides.x, max(sides.y, sides.z));
  float rectangle = (longest + 2.0 * grow) * (abs(twice) / longest + 2.0 * grow);
  bool triangle = 0.5 * abs(twice) * (1.0 + times) * (1.0 + times) < rectangle;
  wfvShapeAlong(grow, front);
  bool turned = (twice > 0.0) != front;
  for (int i = 0; i < 3; i++)
  {
    vec2 c = turned ? wfvC[2 - i] : wfvC[i];
    wfvShape[i] = triangle ? c + times * (c - centre) : wfvShape[i];
  }
  vec2 ndc = 2.0 / wfvViewport.zw;
  for (int i = 0; i < 4; i++)
  {
    if (i < 3 || !triangle)
    {
      wfvEmit(vec4(wfvShape[i] * ndc, 0.0, 1.0), vec3(0.0));
    }
  }
  wfvEnd();
}

// By the sampled distance of the edges. False where that is unknown or large.
bool wfvCoverNarrow(bool front)
{
  float grow = WFV_REACH_SAFETY * wfvReach + WFV_REACH_PAD;
  bool narrow = grow <= 0.25 * min(wfvViewport.z, wfvViewport.w);
  if (narrow)
  {
    wfvCoverTight(grow, front);
  }
  return narrow;
}
