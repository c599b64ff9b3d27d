// SPDX-License-Identifier: BSD-3-Clause
// What vtkWideFoVDataPass writes beside the colour.
in vec3 wfvPositionVSOutput;
uniform int wfvPropNumber; // 0: a prop without an index

#ifndef WFV_FLAT_NORMAL // cover_fragment.glsl knows the triangle's plane
// Of the flat triangle, towards the eye; straight towards it where differences between
// pixels say nothing.
vec3 wfvFlatNormal()
{
  vec3 n = cross(dFdx(wfvPositionVSOutput), dFdy(wfvPositionVSOutput));
  n = dot(n, n) > 0.0 ? normalize(n) : -normalize(wfvPositionVSOutput);
  return dot(n, wfvPositionVSOutput) > 0.0 ? -n : n;
}
#endif

// Of a perspective in stereo, view coordinates; the rays of a wide view know their own.
uniform vec3 wfvDataEye;

#ifndef WFV_DISTANCE
#define WFV_DISTANCE length(position - wfvDataEye)
#endif

vec4 wfvData(vec3 position, int primitive)
{
  float id = wfvPropNumber > 0 ? float(primitive + 1) : 0.0;
  return vec4(WFV_DISTANCE, id, float(wfvPropNumber), 1.0);
}
