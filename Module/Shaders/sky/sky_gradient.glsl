// SPDX-License-Identifier: BSD-3-Clause
// A background by direction: one colour at the horizon and below, another one straight up. Behind
// sky_fragment.glsl.
uniform vec3 wfvHorizon;
uniform vec3 wfvZenith;
uniform vec3 wfvUp; // world, unit length

in vec2 texCoord; // from 0 to 1; VTK complains of a quad whose fragment stage does not ask for it

void main()
{
  wfvPrepareSky();
  if (wfvSkyHide || texCoord.x < -1.0)
  {
    discard;
  }
  vec3 direction = wfvSkyDirection();
  float up = dot(wfvUp, direction);
  float height = wfvAtan2(up, length(direction - up * wfvUp)) / (0.5 * WFV_PI);
  gl_FragData[0] = vec4(mix(wfvHorizon, wfvZenith, max(height, 0.0)), 1.0);
}
