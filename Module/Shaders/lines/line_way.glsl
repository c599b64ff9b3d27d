// SPDX-License-Identifier: BSD-3-Clause
// Direction of a line, from the places of neighbouring fragments.
vec3 wfvLineWay(vec3 place)
{
  vec3 x = dFdx(place);
  vec3 y = dFdy(place);
  return dot(x, x) > dot(y, y) ? x : y;
}
