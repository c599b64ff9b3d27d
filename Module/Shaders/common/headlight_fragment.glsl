// SPDX-License-Identifier: BSD-3-Clause
// Of a perspective: a headlight shines from the eye in every direction, as in wide views
// (light_fragment.glsl), and not along the view axis, which is another one for every screen.
uniform int wfvHeadlights; // one bit a light

// place: of the surface, view coordinates.
vec3 wfvLightDirection(int light, vec3 direction, vec3 place)
{
  return (wfvHeadlights & (1 << light)) != 0 ? normalize(place) : direction;
}
