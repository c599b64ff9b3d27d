// SPDX-License-Identifier: BSD-3-Clause
// Pre-clip of triangles: which way each one is drawn.

void main()
{
  wfvReadCorners();
  vec3 lengths = vec3(length(wfvP[0]), length(wfvP[1]), length(wfvP[2]));
  wfvT = wfvTrianglePlane(lengths);
  if (wfvIsNothing() || wfvOutside(lengths))
  {
    return;
  }
  wfvFacePlanes(lengths);
#if WFV_CURVED_RAYS
  wfvSetDepths(lengths);
#endif
#if WFV_NON_CENTRAL
  wfvSetNc(lengths, wfvT.w > 0.0 ? 1.0 : -1.0);
#else
  if (wfvGrazes())
  {
    return;
  }
#endif
  bool seam = wfvReachesSeam();
#if WFV_SAMPLED
  wfvVertexMode = WFV_RAY_TESTED;
#if WFV_DEBUG_VIEW
  wfvVertexMode += WFV_KIND_UNIT * WFV_KIND_EXACT;
#endif
  wfvCover(wfvT.w < 0.0);
#else
  wfvDraw(seam, wfvEasy(lengths));
#endif
}
