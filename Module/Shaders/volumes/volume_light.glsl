// SPDX-License-Identifier: BSD-3-Clause
// Behind VTK's text of a volume: a light at the eye shines along the ray. WFV_VOLUME_LIGHTS: which
// do, one bit each, in VTK's order, of those without a position where others come first.
vec3 wfvVolumeLight(int light, vec3 direction)
{
#if WFV_POSITIONAL_FIRST
  light -= NUMBER_POS_LIGHTS;
#endif
  return light >= 0 && (WFV_VOLUME_LIGHTS & (1 << light)) != 0 ? wfvFromEye : direction;
}
