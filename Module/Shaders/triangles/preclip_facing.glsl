// SPDX-License-Identifier: BSD-3-Clause
// Pre-clip of triangles: the corners, and the planes as they face the eye.

// First of all.
void wfvReadCorners()
{
  wfvEmitted = 0;
#if WFV_RUNS > 1
  wfvMute = WFV_RUN > 0;
#endif
  for (int i = 0; i < 3; i++)
  {
    wfvP[i] = wfvTilt(gl_in[i].gl_Position.xyz, wfvView) / wfvScale();
  }
}

// Of a triangle whose plane is known. Inside, edge functions are positive from either side; so is
// the plane's.
void wfvFacePlanes(vec3 lengths)
{
  float facing = wfvT.w > 0.0 ? 1.0 : -1.0;
#if WFV_NON_CENTRAL || WFV_CURVED_RAYS
  wfvA = wfvAnchorOf(wfvT, lengths);
#endif
  wfvM *= facing;
  wfvT = vec4(facing * wfvT.xyz, wfvT.w);
  wfvE[0] = facing * wfvEdgePlane(1, 2);
  wfvE[1] = facing * wfvEdgePlane(2, 0);
  wfvE[2] = facing * wfvEdgePlane(0, 1);
  for (int i = 0; i < 3; i++)
  {
    wfvN[i] = vec3(wfvE[i]);
  }
#if WFV_EXACT
  wfvFindRises();
#endif
}
