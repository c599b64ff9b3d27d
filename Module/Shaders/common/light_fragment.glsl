// SPDX-License-Identifier: BSD-3-Clause
// A headlight shines from the eye in every direction, not along the view axis.
uniform int wfvHeadlights; // one bit a light; made a constant where the shader is built
#ifndef WFV_FROM_EYE
#define WFV_FROM_EYE normalize(vertexVC.xyz)
#endif
vec3 wfvFromEye = vec3(0.0); // unit vector from the eye to this fragment, view coordinates

vec3 wfvLightDirection(int light, vec3 direction)
{
  return (wfvHeadlights & (1 << light)) != 0 ? wfvFromEye : direction;
}
