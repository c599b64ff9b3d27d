// SPDX-License-Identifier: BSD-3-Clause
// Pre-clip of triangles: between which depths it may be, where rays are curves.

flat out vec2 wfvDepths; // curved_fragment.glsl
vec2 wfvDepthsHere = vec2(0.0); // NDC

void wfvWriteDepths()
{
  wfvDepths = wfvDepthsHere;
}
