// SPDX-License-Identifier: BSD-3-Clause
// Fragment side of point_on_directions.glsl.

flat in vec3 wfvPointAt;
flat in float wfvPointDepth;

float wfvDepth = 0.0; // window depth, 0 to 1
bool wfvHide = false; // not covered: discarded once the stock shader has run
vec2 wfvPointCoord = vec2(0.0); // what gl_PointCoord is for OpenGL's own points
const bool wfvFront = true; // as points are

void wfvInterpolate(); // generated: sets the stock shader's inputs

uniform float wfvPointSize; // pixels

// Where a sample lies inside a pixel, from its centre, pixels; one sample: the centre.
uniform int wfvSamples;
uniform vec2 wfvSampleOffsets[WFV_MOST_SAMPLES];

// Pixels: squares are larger by so much, or a point between two pixels, whose local maps are not quite
// the same, would be in neither.
const float WFV_POINT_SLACK = 0.01;

bool wfvInSquare(vec2 offset)
{
  vec3 to = wfvInLocalMap(wfvPointAt, wfvLocalDirection(offset));
  return to.z > 0.0 && max(abs(to.x), abs(to.y)) <= 0.5 * wfvPointSize + WFV_POINT_SLACK;
}

void wfvPrepare()
{
  wfvTakeLocalMap();
  vec3 to = wfvInLocalMap(wfvPointAt, wfvLocal.direction);
  wfvPointCoord = vec2(-0.5, 0.5) * to.xy / (0.5 * wfvPointSize) + 0.5;
  wfvDepth = wfvPointDepth;
  wfvInterpolate();
  int mask = wfvInSquare(vec2(0.0)) ? -1 : 0;
  for (int i = 0; i < wfvSamples && wfvSamples > 1; i++)
  {
    mask = i == 0 ? 0 : mask;
    mask |= wfvInSquare(wfvSampleOffsets[i]) ? 1 << i : 0;
  }
#ifdef GL_ARB_sample_shading
  gl_SampleMask[0] = mask;
#endif
  wfvHide = mask == 0 || !wfvLocal.inside;
}
