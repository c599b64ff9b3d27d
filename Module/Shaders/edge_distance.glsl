// SPDX-License-Identifier: BSD-3-Clause
// Fragment side of triangles whose edges show: how far they are.

// What an edge function that does not change from pixel to pixel is divided by.
const float WFV_NO_SLOPE = 1e-30;

// Pixels: farther edges show nothing here.
const float WFV_EDGE_NEAR = 12.0;

// Distance of an edge whose function is e here, with this slope per pixel. A second step, from
// the place that the first one leads to, with the slope there, is for where the map bends
// within a few pixels: beside a pole.
float wfvEdgeDistance(int i, float e, vec2 slope)
{
  vec2 foot = -e * slope / max(dot(slope, slope), WFV_NO_SLOPE);
  WfvRay there = wfvRayAt(foot);
  WfvRay right = wfvRayAt(foot + vec2(1.0, 0.0));
  WfvRay above = wfvRayAt(foot + vec2(0.0, 1.0));
  if (!there.inside || !right.inside || !above.inside)
  {
    return length(foot);
  }
  float f = wfvEdgesAt(there.direction)[i];
  vec2 g = vec2(wfvEdgesAt(right.direction - there.direction)[i],
    wfvEdgesAt(above.direction - there.direction)[i]);
  // from the pixel straight to the tangent of the edge there
  return abs(f - dot(g, foot)) / max(length(g), WFV_NO_SLOPE);
}

// Distance, in pixels, of this pixel's centre from the great circles of the edges opposite to
// corners 0, 1, 2: the edge function over its slope, both by the rays of pixels. So it is the
// same from both sides of an edge, whichever way each of the two triangles is drawn, and does
// not ask what the neighbouring pixels show: they may see another triangle, or nothing.
vec3 wfvEdgeDistances()
{
  WfvRay ray = wfvRayAt(vec2(0.0));
  bool rim;
  mat2x3 pixel = wfvRaySteps(ray, rim);
  vec3 e = wfvEdgesAt(ray.direction);
  vec3 x = wfvEdgesAt(pixel[0]);
  vec3 y = wfvEdgesAt(pixel[1]);
  vec3 d = abs(e) / max(sqrt(x * x + y * y), vec3(WFV_NO_SLOPE));
  for (int i = 0; i < 3; i++)
  {
    if (d[i] < WFV_EDGE_NEAR)
    {
      d[i] = wfvEdgeDistance(i, e[i], vec2(x[i], y[i]));
    }
  }
  return d;
}
