// SPDX-License-Identifier: BSD-3-Clause
// Normal of a line for its light: across it, and towards the eye.
vec3 wfvLineNormal(vec3 direction, vec3 position)
{
#ifdef WFV_LINE_SEEN
  position = WFV_LINE_SEEN;
#endif
  vec3 n = cross(cross(direction, -position), direction);
  float l = length(n);
  return l > 0.0 ? n / l : normalize(-position);
}
