// SPDX-License-Identifier: BSD-3-Clause
// Pre-clip of triangles on the faces of a cube (before planes_fp64.glsl).

// Radians, and pixels where that is less: by so much all edges are turned about the x axis. On the
// faces of a cube many rays meet vertices of a regular mesh round its middle exactly, and would be
// decided by the rounding of a plane and a direction, edge by edge; turned by a few times that,
// they miss them, and the edges round a vertex agree. Not on maps with a pole or an antipode, by
// which the least turn is many pixels.
#if WFV_FP64
const float WFV_EDGE_TURN = 4e-13; // rays are in double too
#else
const float WFV_EDGE_TURN = 4e-7;
#endif
const float WFV_EDGE_TURN_PIXELS = 1e-3;

vec3 wfvEdgeTurn()
{
  float pixel = 2.0 * wfvView.halfFov.y / (wfvViewport.w * wfvTile.y);
  return vec3(min(WFV_EDGE_TURN, WFV_EDGE_TURN_PIXELS * pixel), 0.0, 0.0);
}
