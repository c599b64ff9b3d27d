// SPDX-License-Identifier: BSD-3-Clause
// Tessellation: the corners of the pieces, in view coordinates. The pre-clip behind takes
// each piece as a triangle of its own.
//
// Places on an edge are found from its two ends in lexicographic order, so that both
// triangles at an edge have the same corners to the last bit. Places are even along the
// chord between the directions of two corners, not along the edge itself: an edge that
// runs away from the eye would get its pieces where they are not seen.

layout(triangles, equal_spacing, ccw) in;

in vec4 wfvFirstSteps[]; // of the edge opposite to each corner
in vec4 wfvLastSteps[];

vec3 wfvP[3] = vec3[3](vec3(0.0), vec3(0.0), vec3(0.0));
vec3 wfvLengths = vec3(0.0);

// Where on the chord, 0 to 1, a place at the share s of the pieces of an edge lies.
float wfvSpread(int edge, float s)
{
  float before = 0.0;
  for (int k = 0; k < WFV_INTERVALS; k++)
  {
    float here = k < 4 ? wfvFirstSteps[edge][k] : wfvLastSteps[edge][k - 4];
    if (s <= here || k == WFV_INTERVALS - 1)
    {
      float part = here > before ? clamp((s - before) / (here - before), 0.0, 1.0) : 1.0;
      return (float(k) + part) / float(WFV_INTERVALS);
    }
    before = here;
  }
  return 1.0;
}

// A place between two corners: sets their weights, returns the point.
vec3 wfvOnEdge(int edge, int i, int j)
{
  bool ordered = wfvOrdered(wfvP[i], wfvP[j]);
  int first = ordered ? i : j;
  int second = ordered ? j : i;
  float t = wfvSpread(edge, gl_TessCoord[second]);
  float u = (1.0 - t) / wfvLengths[first];
  float v = t / wfvLengths[second];
  wfvWeights = vec3(0.0);
  wfvWeights[first] = u / (u + v);
  wfvWeights[second] = v / (u + v);
  return (u * wfvP[first] + v * wfvP[second]) / (u + v);
}

vec3 wfvInside()
{
  vec3 w = gl_TessCoord / wfvLengths;
  wfvWeights = w / (w.x + w.y + w.z);
  return (w.x * wfvP[0] + w.y * wfvP[1] + w.z * wfvP[2]) / (w.x + w.y + w.z);
}

vec3 wfvPoint()
{
  for (int i = 0; i < 3; i++)
  {
    int j = i == 2 ? 0 : i + 1;
    int k = i == 0 ? 2 : i - 1;
    if (gl_TessCoord[j] == 0.0 && gl_TessCoord[k] == 0.0)
    {
      wfvWeights = vec3(0.0);
      wfvWeights[i] = 1.0;
      return wfvP[i];
    }
  }
  for (int i = 0; i < 3; i++)
  {
    if (gl_TessCoord[i] == 0.0)
    {
      return wfvOnEdge(i, i == 2 ? 0 : i + 1, i == 0 ? 2 : i - 1);
    }
  }
  return wfvInside();
}

void main()
{
  for (int i = 0; i < 3; i++)
  {
    wfvP[i] = gl_in[i].gl_Position.xyz;
    wfvLengths[i] = max(wfvLength(wfvP[i]), 1e-30);
  }
  gl_Position = vec4(wfvPoint(), 1.0);
  wfvInterpolate();
}
