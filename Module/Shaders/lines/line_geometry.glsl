// SPDX-License-Identifier: BSD-3-Clause
// Lines: shapes that surely contain the picture of each, for line_fragment.glsl, which
// says what the picture is. An arc that the map curves little gets one rectangle along its
// chord. Others are parted at the places where the map may curve or part them, and each
// part gets a rectangle of its own; which part a pixel belongs to is decided there.

void main()
{
  vec3 p = wfvTilt(gl_in[0].gl_Position.xyz, wfvView) / wfvScale();
  vec3 q = wfvTilt(gl_in[1].gl_Position.xyz, wfvView) / wfvScale();
  float longest = max(wfvLength(p), wfvLength(q));
  // inside the near sphere, or not a number, or where float32 ends
  if (!(longest * wfvScale() >= wfvView.radii.x) || !(longest < 1e18))
  {
    return;
  }
  wfvQuadsLeft = WFV_LINE_VERTICES / 4;
#if WFV_NON_CENTRAL
  wfvEmitNc(p, q);
#else
  wfvLevel = false;
  bool plane = wfvFrameArc(p, q);
  bool dots = !plane && wfvArcEnds.y > wfvArcEnds.x;
#if WFV_FACES
  wfvEmitOnFaces(dots);
#elif WFV_SAMPLED
  wfvEmitOnDirections(dots);
#else
  wfvEmitArc(dots);
#endif
#endif
}
