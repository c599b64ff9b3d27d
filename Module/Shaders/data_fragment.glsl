// SPDX-License-Identifier: BSD-3-Clause
// What vtkWideFoVDataPass writes beside the colour.
in vec3 wfvPositionVSOutput;
uniform int wfvPropNumber; // 0: a prop without an index

// Of the flat triangle, towards the eye.
vec3 wfvFlatNormal()
{
  vec3 n = normalize(cross(dFdx(wfvPositionVSOutput), dFdy(wfvPositionVSOutput)));
  return dot(n, wfvPositionVSOutput) > 0.0 ? -n : n;
}

vec4 wfvData(vec3 position, int primitive)
{
  float id = wfvPropNumber > 0 ? float(primitive + 1) : 0.0;
  return vec4(length(position), id, float(wfvPropNumber), 1.0);
}
