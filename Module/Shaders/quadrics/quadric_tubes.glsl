// SPDX-License-Identifier: BSD-3-Clause
// Geometry stage of lines drawn as tubes: each segment is the hull of two spheres, whose
// radius is so many pixels at each end.

layout(lines) in;
layout(triangle_strip, max_vertices = WFV_SPAN_VERTICES) out;

vec4 wfvEnd(int i)
{
  vec4 p = gl_in[i].gl_Position;
  vec3 centre = wfvTilt(p.xyz / p.w, wfvView) / wfvScale();
  return vec4(centre, wfvPixelRadius(centre));
}

void main()
{
  wfvSphereHere = wfvEnd(0);
  wfvOtherHere = wfvEnd(1);
  wfvCoverSpan(wfvSphereHere, wfvOtherHere);
}
