// SPDX-License-Identifier: BSD-3-Clause
// Covers a triangle, whose edges stay near their chords, with little more than its own
// picture: hardly more pixels than its chords would draw, though each is decided by its ray.

uniform int wfvSamples; // of the fragment stage; one: pixel centres alone are looked at

// Pixels added all round: a corner's place in float32 errs by 0.02 in a picture 8192 wide
// (Agreement of GpuMathTest.cxx), and rasterizers snap corners by up to 1/128.
const float WFV_TIGHT_PAD = 0.0625;

// Factor on the sampled distance of the edges from their chords, and pixels added to it, for
// what lies between the samples.
const float WFV_CHORD_SAFETY = 1.5;
const float WFV_CHORD_PAD = 0.5;

// True where no pixel centre lies between two places, in pixels from the tile's centre.
bool wfvBetweenCentres(vec2 low, vec2 high)
{
  vec2 first = ceil(low + 0.5 * wfvViewport.zw - 0.5);
  vec2 last = floor(high + 0.5 * wfvViewport.zw - 0.5);
  return WFV_CURVED_RAYS == 0 && wfvSamples <= 1 && (first.x > last.x || first.y > last.y);
}

vec2 wfvShape[4]; // pixels of the tile, from its centre

// A rectangle, by its first corner and its sides; the right one, then to the left of it.
void wfvRectangle(vec2 first, vec2 right, vec2 up, bool front)
{
  wfvShape[0] = first;
  wfvShape[1] = first + (front ? right : up);
  wfvShape[2] = first + (front ? up : right);
  wfvShape[3] = first + right + up;
}

// (No index is computed: that would put the corners into memory.)
vec2 wfvShapeCorner(int i)
{
  return i == 0 ? wfvShape[0] : i == 1 ? wfvShape[1] : i == 2 ? wfvShape[2] : wfvShape[3];
}

// So many corners of it; none is no shape.
void wfvEmitShape(int corners)
{
  vec2 ndc = 2.0 / wfvViewport.zw;
  for (int i = 0; i < corners; i++)
  {
    wfvEmit(vec4(wfvShapeCorner(i) * ndc, 0.0, 1.0), vec3(0.0));
  }
  wfvEnd();
}

// A rectangle along the longest chord, which begins at a place: narrower than one along the axes
// for what lies askew. grow: pixels, beyond that chord and elsewhere.
void wfvShapeAlong(vec2 from, vec2 way, vec2 third, vec2 grow, bool front)
{
  float l = length(way);
  vec2 along = l > 1e-6 ? way / l : vec2(1.0, 0.0);
  vec2 across = vec2(-along.y, along.x);
  float high = dot(third - from, across);
  vec2 sides = high > 0.0 ? vec2(-grow.x, high + grow.y) : vec2(high - grow.y, grow.x);
  wfvRectangle(from - along * grow.y + across * sides.x, along * (l + 2.0 * grow.y),
    across * (sides.y - sides.x), front);
}

// grow: pixels to move the side opposite to corner i out by. The sides next to the largest angle
// move alike: what one of them leaves its chord by may lie beyond the line of the other. A needle's would
// meet far beyond its ends, and it takes the rectangle along its longest side, as everything does
// that is smaller so. Of the places wfvC; returns the number of corners.
int wfvShapeRound(vec3 grow, bool front)
{
  float most = max(grow.x, max(grow.y, grow.z));
  if (wfvBetweenCentres(min(wfvC[0], min(wfvC[1], wfvC[2])) - most,
        max(wfvC[0], max(wfvC[1], wfvC[2])) + most))
  {
    return 0;
  }
  vec3 sides = vec3(length(wfvC[2] - wfvC[1]), length(wfvC[0] - wfvC[2]), length(wfvC[1] - wfvC[0]));
  float longest = max(sides.x, max(sides.y, sides.z));
  bool first = sides.x == longest;
  bool second = !first && sides.y == longest;
  // the longest side is the one opposite to c[0]; the others move alike
  vec2 c[3] = vec2[3](first ? wfvC[0] : second ? wfvC[1] : wfvC[2],
    first ? wfvC[1] : second ? wfvC[2] : wfvC[0], first ? wfvC[2] : second ? wfvC[0] : wfvC[1]);
  vec3 out_ = first ? grow : second ? grow.yzx : grow.zxy;
  out_.yz = vec2(max(out_.y, out_.z));
  vec2 a = c[1] - c[0];
  vec2 b = c[2] - c[0];
  float twice = a.x * b.y - a.y * b.x;
  vec3 times = out_ * vec3(longest, length(b), length(a)) / abs(twice); // over the heights
  float all_ = 1.0 + times.x + times.y + times.z;
  float rectangle = (longest + 2.0 * out_.y) * (abs(twice) / longest + out_.x + out_.y);
  bool triangle = 0.5 * abs(twice) * all_ * all_ < rectangle;
  wfvShapeAlong(c[1], c[2] - c[1], c[0], out_.xy, front);
  vec2 weighed = times.x * c[0] + times.y * c[1] + times.z * c[2];
  bool turned = (twice > 0.0) != front;
  for (int i = 0; i < 3 && triangle; i++)
  {
    wfvShape[i] = all_ * (turned ? c[2 - i] : c[i]) - weighed;
  }
  return triangle ? 3 : 4;
}

// Of the places wfvC.
void wfvCoverTight(float grow, bool front)
{
  wfvEmitShape(wfvShapeRound(vec3(grow), front));
}

// By the sampled distance of the edges: pixels to grow by.
float wfvNarrowGrow()
{
  return WFV_CHORD_SAFETY * wfvChordBound + WFV_CHORD_PAD;
}

// False where that is unknown or large.
bool wfvIsNarrow()
{
  return wfvNarrowGrow() <= 0.25 * min(wfvViewport.z, wfvViewport.w);
}
