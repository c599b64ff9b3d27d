// SPDX-License-Identifier: BSD-3-Clause
// What vtkWideFoVDataPass writes beside the colour.
#ifndef WFV_PLACE // data_perspective.glsl
in vec3 wfvPositionVSOutput;
#define WFV_PLACE wfvPositionVSOutput
#endif
uniform int wfvPropNumber; // 0: a prop without an index

#ifndef WFV_FLAT_NORMAL // cover_surface.glsl knows the triangle's plane
// Of the flat triangle, towards the eye; straight towards it where differences between
// pixels say nothing.
vec3 wfvFlatNormal()
{
  vec3 place = WFV_PLACE;
  vec3 n = cross(dFdx(place), dFdy(place));
  n = dot(n, n) > 0.0 ? normalize(n) : -normalize(place);
  return dot(n, place) > 0.0 ? -n : n;
}
#endif

// What is lit by, but where that is no number: stock VTK's of a pixel at whose neighbours the
// triangle has the same place, or none.
vec3 wfvDataNormal(vec3 n)
{
  vec3 flat_ = wfvFlatNormal();
  return dot(n, n) > 0.0 ? n : flat_;
}

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
