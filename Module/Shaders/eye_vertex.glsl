// SPDX-License-Identifier: BSD-3-Clause
// View coordinates of a vertex of the buffer: the difference from the eye first, while the
// coordinates are still exact, then the rotation (see vtkWideFoVEye.h).
uniform int wfvEyeKnown;
uniform vec3 wfvEyeHigh;
uniform vec3 wfvEyeLow;

#if WFV_REST && defined(GL_ARB_gpu_shader_fp64)
out vec3 wfvRest; // what float32 leaves off, for preclip_planes.glsl

vec3 wfvRotated(mat3 toView, vec3 p)
{
  dvec3 whole = dmat3(toView) * ((dvec3(p) - dvec3(wfvEyeHigh)) - dvec3(wfvEyeLow));
  vec3 high = vec3(whole);
  wfvRest = wfvEyeKnown != 0 ? vec3(whole - dvec3(high)) : vec3(0.0);
  return high;
}
#else
vec3 wfvRotated(mat3 toView, vec3 p)
{
  return toView * ((p - wfvEyeHigh) - wfvEyeLow);
}
#endif

vec4 wfvFromEyeOf(mat4 toView, vec4 p)
{
  vec3 relative = wfvRotated(mat3(toView), p.xyz);
  return wfvEyeKnown != 0 ? vec4(relative, 1.0) : toView * p;
}
