// SPDX-License-Identifier: BSD-3-Clause
// Geometry stage of balls: one point in, the rectangles round its ball out. The radius
// is the sphere mapper's own, or, for points drawn as spheres, so many pixels.

layout(points) in;
layout(triangle_strip, max_vertices = 8) out;

void main()
{
  vec4 p = gl_in[0].gl_Position;
  vec3 centre = wfvTilt(p.xyz / p.w, wfvView) / wfvScale();
  wfvBallHere = vec4(centre, WFV_BALL_RADIUS);
  wfvOtherHere = vec4(0.0);
  wfvShareHere = vec2(0.0, 1.0);
  if (!wfvBallCulled(wfvBallHere))
  {
    // from inside, its back is seen
    wfvCoverCap(centre, wfvBallAngle(wfvBallHere), wfvLength(centre) > wfvBallHere.w);
  }
}
