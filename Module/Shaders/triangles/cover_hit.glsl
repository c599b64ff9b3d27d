// SPDX-License-Identifier: BSD-3-Clause
// Fragment side of the pre-clip: whether this pixel sees the triangle.

bool wfvIsHit(WfvRay ray, vec3 e)
{
#if WFV_EXACT && !WFV_MULTISAMPLE
  return wfvCoverage(ray, e, vec3(0.0), vec3(0.0), false);
#else
  bool rim;
#if WFV_EXACT
  mat2x3 pixel = wfvQuadSteps(ray, rim);
#else
  mat2x3 pixel = wfvRaySteps(ray, rim);
#endif
  vec3 x = wfvEdgeStep(ray.direction, pixel[0]);
  vec3 y = wfvEdgeStep(ray.direction, pixel[1]);
  return wfvCoverage(ray, e, x, y, rim);
#endif
}

// The ray of the pixel's centre, and the edge functions there.
WfvRay wfvLook(out vec3 e)
{
#if !WFV_EXACT
  wfvByChord = (wfvMode & 1) == 0;
#endif
#if WFV_DOUBLES
  WfvFp64Ray ray = wfvFp64RayAt();
  dvec3 edges = wfvEdgesAt(ray.direction);
  e = vec3(edges);
  wfvOfPlane = edges.x + edges.y + edges.z;
  return WfvRay(vec3(ray.direction), ray.inside);
#else
  WfvRay ray = wfvSurfaceRay(vec2(0.0));
  e = wfvEdgesAt(ray.direction);
  return ray;
#endif
}
