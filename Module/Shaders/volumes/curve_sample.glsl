// SPDX-License-Identifier: BSD-3-Clause
// Samples on the curve that a pixel sees along (behind volume_curve.glsl).

// Puts the sample on the curve; true where it is not to be taken.
bool wfvSkipsSample()
{
  wfvStraight = g_dataPos;
  bool inside;
  vec3 place = wfvCurveAt(wfvSampleDistance(), inside);
  g_dataPos = wfvTextureOf(place);
#if WFV_HEADLIGHT
  vec4 back = in_inverseVolumeMatrix[0] * in_inverseModelViewMatrix * vec4(-place, 0.0);
  g_ldir[0] = g_vdir[0] = g_h[0] = normalize(back.xyz);
#endif
  bool outside = !inside || any(lessThan(g_dataPos, in_texMin[0])) ||
    any(greaterThan(g_dataPos, in_texMax[0]));
#if WFV_CLIPS
  vec3 world = (in_inverseModelViewMatrix * vec4(place, 1.0)).xyz;
  for (int i = 0; i < int(in_clippingPlanes[0]); i += 6)
  {
    vec3 origin = vec3(in_clippingPlanes[i + 1], in_clippingPlanes[i + 2], in_clippingPlanes[i + 3]);
    vec3 normal = vec3(in_clippingPlanes[i + 4], in_clippingPlanes[i + 5], in_clippingPlanes[i + 6]);
    outside = outside || dot(origin - world, normal) > 0.0;
  }
#endif
  return outside;
}
