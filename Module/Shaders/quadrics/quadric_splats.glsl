// SPDX-License-Identifier: BSD-3-Clause
// Geometry stage of point gaussians: a disc about each point that faces the eye.

layout(points) in;
layout(triangle_strip, max_vertices = 8) out;

void main()
{
  vec4 p = gl_in[0].gl_Position;
  vec3 centre = wfvTilt(p.xyz / p.w, wfvView) / wfvScale();
  wfvSphereHere = vec4(centre, radiusVCVSOutput[0] / wfvScale());
  wfvOtherHere = vec4(0.0);
  wfvShareHere = vec2(0.0, 1.0);
  if (!wfvSphereCulled(wfvSphereHere))
  {
    // nothing of the disc is nearer than its centre
    float d = wfvLength(centre);
    wfvCoverCap(centre, wfvAtan2(wfvSphereHere.w, d) + wfvGrowOf(d), true);
  }
}
