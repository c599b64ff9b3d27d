// SPDX-License-Identifier: BSD-3-Clause
// How the direction changes from pixel to pixel (behind ray_fragment.glsl).

// The change of direction per pixel along one axis, by the ray of the next pixel or, where
// that is outside the map or on another face, of the one before.
vec3 wfvRayStep(WfvRay ray, vec2 axis)
{
  WfvRay next = wfvRayAt(axis);
  WfvRay before = wfvRayAt(-axis);
#if WFV_FACES
  next.inside = next.inside && wfvFaceBeside(axis) == wfvFaceBeside(vec2(0.0));
#endif
  return next.inside ? next.direction - ray.direction : ray.direction - before.direction;
}

// The change of direction per pixel along x and y, by the differences within this quad. rim:
// its four pixels are not all inside the map, or on one face, so these say nothing.
mat2x3 wfvQuadSteps(WfvRay ray, out bool rim)
{
  float inside = ray.inside ? 0.0 : 1.0;
  rim = inside + abs(dFdx(inside)) + abs(dFdy(inside)) > 0.0;
#if WFV_FACES
  float face = float(wfvFaceBeside(vec2(0.0)));
  rim = rim || abs(dFdx(face)) + abs(dFdy(face)) > 0.0;
#endif
  return mat2x3(dFdx(ray.direction), dFdy(ray.direction));
}

// The same, at a rim by the rays of the next pixels.
mat2x3 wfvRaySteps(WfvRay ray, out bool rim)
{
  mat2x3 steps = wfvQuadSteps(ray, rim);
  if (rim)
  {
    steps = mat2x3(wfvRayStep(ray, vec2(1.0, 0.0)), wfvRayStep(ray, vec2(0.0, 1.0)));
  }
  return steps;
}
