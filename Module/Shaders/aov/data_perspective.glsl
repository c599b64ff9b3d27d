// SPDX-License-Identifier: BSD-3-Clause
// Where a fragment of a perspective is, view coordinates, for data_fragment.glsl. Of a triangle with
// a corner in the eye the interpolated place may be no number: there the pixel and its depth tell.
in vec3 wfvPositionVSOutput;
uniform mat4 wfvPixelToView;

vec3 wfvPlace()
{
  vec4 place = wfvPixelToView * vec4(gl_FragCoord.xyz, 1.0);
  return dot(abs(wfvPositionVSOutput), vec3(1.0)) <= 1e38 ? wfvPositionVSOutput : place.xyz / place.w;
}

#define WFV_PLACE wfvPlace()
