// SPDX-License-Identifier: BSD-3-Clause
// Geometry stage of the stick mapper: a cylinder with flat ends about each point.

layout(points) in;
layout(triangle_strip, max_vertices = WFV_SPAN_VERTICES) out;

void main()
{
  vec4 p = gl_in[0].gl_Position;
  vec3 centre = wfvTilt(p.xyz / p.w, wfvView) / wfvScale();
  vec3 axis = normalize(wfvTilt(orientVCVSOutput[0], wfvView));
  float radius = radiusVCVSOutput[0] / wfvScale();
  float half_ = 0.5 * lengthVCVSOutput[0] / wfvScale();
  wfvSphereHere = vec4(centre, radius);
  wfvOtherHere = vec4(axis, half_);
  wfvCoverSpan(vec4(centre - half_ * axis, radius), vec4(centre + half_ * axis, radius));
}
