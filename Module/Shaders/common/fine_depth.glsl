// SPDX-License-Identifier: BSD-3-Clause
// Order in finer steps than a depth buffer has. A depth that a shader writes is a float32: from the middle
// of the scene on its steps are no finer than those of 24 bits. What lies nearer to each other than that
// comes out at one depth, and the one that is drawn last is seen.

#if WFV_DOUBLES && defined(GL_ARB_shader_image_load_store) && !WFV_DEPTH_MAPPING(wfvView)
// Of each pixel of the viewport, the nearest that was drawn there in this frame.
layout(r32ui) coherent uniform uimage2D wfvNearest;
uniform ivec2 wfvNearestFrom; // the viewport's corner
uniform int wfvNearestKnown;  // 0: leave it alone

// Of the range of depth.
const double WFV_FINE_STEPS = 4294967295.0lf;

// True where something nearer was drawn. To be asked last of all, for what is not discarded; depth: as it
// is written, by which a mapper may have moved it. Fragments of one pixel that run at the same time may miss
// each other: the depth buffer alone orders them then. None is behind what is not drawn.
bool wfvIsBehind(float depth)
{
  if (wfvNearestKnown == 0)
  {
    return false;
  }
  double fine = wfvFineDepth + double(depth - wfvDepth);
  uint step_ = uint(clamp(fine, 0.0lf, 1.0lf) * WFV_FINE_STEPS);
  ivec2 place = ivec2(gl_FragCoord.xy) - wfvNearestFrom;
  bool behind = imageLoad(wfvNearest, place).x < step_;
  if (!behind)
  {
    imageStore(wfvNearest, place, uvec4(step_));
  }
  return behind;
}
#else
bool wfvIsBehind(float depth)
{
  return false;
}
#endif
