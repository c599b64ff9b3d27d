// SPDX-License-Identifier: BSD-3-Clause
// Geometry stage of spheres: one point in, the rectangles round its sphere out. The radius
// is the sphere mapper's own, or, for points drawn as spheres, so many pixels.

layout(points) in;
layout(triangle_strip, max_vertices = 8) out;

void main()
{
  vec4 p = gl_in[0].gl_Position;
  vec3 centre = wfvTilt(p.xyz / p.w, wfvView) / wfvScale();
  wfvSphereHere = vec4(centre, WFV_SPHERE_RADIUS);
  wfvOtherHere = vec4(0.0);
  wfvShareHere = vec2(0.0, 1.0);
  if (!wfvSphereCulled(wfvSphereHere))
  {
    // from inside, its back is seen
    wfvCoverCap(centre, wfvSphereAngle(wfvSphereHere), wfvLength(centre) > wfvSphereHere.w);
  }
}
