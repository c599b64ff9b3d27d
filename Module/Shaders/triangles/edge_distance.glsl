// SPDX-License-Identifier: BSD-3-Clause
// Fragment side of triangles whose edges show: how far they are.

// What an edge function that does not change from pixel to pixel is divided by.
const float WFV_NO_SLOPE = 1e-30;

// Pixels: farther ones do not show here, unless edges are drawn far wider than usual, whose
// first step then has to do.
const float WFV_EDGE_NEAR = 12.0;

// Newton's steps: the first is all that is needed where a map hardly curves within a few
// pixels, but beside a pole it does.
const int WFV_EDGE_STEPS = 5;

// Pixels: a step after which the next one changes nothing that is seen.
const float WFV_EDGE_STEP = 0.01;

// Pixels, each way, of the differences that slopes come from.
const float WFV_EDGE_DIFFERENCE = 0.25;

// The ray so many pixels beside the centre, by the map of the face that the centre lies on
// where the map is one of several.
WfvRay wfvRayOfHere(vec2 offset)
{
  WfvRay ray = wfvSurfaceRay(offset);
#if WFV_FACES
  int face = wfvFaceBeside(vec2(0.0));
  ray.direction = wfvFaceDirection(wfvOnFace(wfvPlaceBeside(offset) / wfvView.scale, face), face);
  ray.inside = true;
#endif
  return ray;
}

// Distance of an edge whose function is e here, with this slope per pixel: from the foot of the
// perpendicular on its tangent to that on its tangent there, and so on.
float wfvEdgeDistance(int i, float e, vec2 slope)
{
  vec2 foot = vec2(0.0);
  for (int k = 0; k < WFV_EDGE_STEPS; k++)
  {
    vec2 next = slope * ((dot(slope, foot) - e) / max(dot(slope, slope), WFV_NO_SLOPE));
    float moved = length(next - foot);
    foot = next;
    WfvRay there = wfvRayOfHere(foot);
    if (!there.inside || (k > 0 && moved < WFV_EDGE_STEP))
    {
      break;
    }
    vec2 x = vec2(WFV_EDGE_DIFFERENCE, 0.0);
    vec3 right = wfvRayOfHere(foot + x.xy).direction - wfvRayOfHere(foot - x.xy).direction;
    vec3 above = wfvRayOfHere(foot + x.yx).direction - wfvRayOfHere(foot - x.yx).direction;
    e = wfvEdgesAt(there.direction)[i];
    slope =
      vec2(wfvEdgeStep(there.direction, right)[i], wfvEdgeStep(there.direction, above)[i]) /
      (2.0 * WFV_EDGE_DIFFERENCE);
  }
  return length(foot);
}

// Distance, in pixels, of this pixel's centre from the great circles of the edges opposite to
// corners 0, 1, 2: the edge function over its slope, both by the rays of pixels. So it is the
// same from both sides of an edge, whichever way each of the two triangles is drawn, and does
// not ask what the neighbouring pixels show: they may see another triangle, or nothing.
vec3 wfvEdgeDistances()
{
  WfvRay ray = wfvSurfaceRay(vec2(0.0));
#if WFV_CURVED_RAYS
  mat2x3 pixel = mat2x3(wfvSurfaceRay(vec2(1.0, 0.0)).direction - ray.direction,
    wfvSurfaceRay(vec2(0.0, 1.0)).direction - ray.direction);
#else
  bool rim;
  mat2x3 pixel = wfvRaySteps(ray, rim);
#endif
  vec3 e = wfvEdgesAt(ray.direction);
  vec3 x = wfvEdgeStep(ray.direction, pixel[0]);
  vec3 y = wfvEdgeStep(ray.direction, pixel[1]);
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
