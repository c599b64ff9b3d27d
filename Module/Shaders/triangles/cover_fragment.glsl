// SPDX-License-Identifier: BSD-3-Clause
// Fragment side of the pre-clip: barycentric coordinates, coverage and depth of the
// primitive at this pixel, before the stock shader runs.

void wfvPrepare()
{
  vec3 e;
  WfvRay ray = wfvLook(e);
  bool covered = wfvIsHit(ray, e);
#if WFV_MULTISAMPLE
  ray.direction = wfvShown;
  e = wfvEdgesAt(ray.direction);
#endif
  float approach = wfvApproach(ray.direction);
#if WFV_NON_CENTRAL
  wfvFacing = wfvTurn;
#endif
#if WFV_EXACT
  wfvFront = gl_FrontFacing == (wfvFacing > 0.0);
  wfvB = wfvWeigh(e);
  wfvSetDistance(wfvMeet(ray.direction, approach));
  wfvSetSurface(ray.direction);
  bool meets = wfvFacing * approach > 0.0;
#else
  wfvFront = gl_FrontFacing;
  wfvB = wfvByChord ? wfvBary / (wfvBary.x + wfvBary.y + wfvBary.z) : wfvWeigh(e);
  wfvSetDistance(wfvByChord ? length(wfvPosition) : wfvMeet(ray.direction, approach));
  bool meets = wfvByChord || approach > 0.0;
#endif
#if WFV_EDGES
  wfvEdgePixels = wfvEdgeDistances();
#endif
  wfvInterpolate();
  wfvHide = !(covered && meets && wfvDepth >= 0.0 && wfvDepth <= 1.0);
#if WFV_EXACT
  wfvOrder(approach, e);
#endif
  wfvDepth += !wfvFront ? WFV_BEHIND : 0.0;
}
