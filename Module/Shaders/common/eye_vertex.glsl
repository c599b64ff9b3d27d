// SPDX-License-Identifier: BSD-3-Clause
// View coordinates of a vertex of the buffer: the difference from the eye first, while the
// coordinates are still exact, then the rotation (see Eye.h).
uniform int wfvEyeKnown;
uniform vec3 wfvEyeHigh;
uniform vec3 wfvEyeLow;

#if WFV_MODEL
out vec3 wfvModel; // as the buffer has it, for planes_fp64.glsl
#endif

vec4 wfvFromEyeOf(mat4 toView, vec4 p)
{
#if WFV_MODEL
  wfvModel = p.xyz;
#endif
  vec3 relative = (p.xyz - wfvEyeHigh) - wfvEyeLow;
  return wfvEyeKnown != 0 ? vec4(mat3(toView) * relative, 1.0) : toView * p;
}
