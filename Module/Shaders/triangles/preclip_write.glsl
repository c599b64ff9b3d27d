// SPDX-License-Identifier: BSD-3-Clause
// Pre-clip of triangles: writes the outputs of a vertex, and emits it.

void wfvWriteRises()
{
#if WFV_EXACT
  wfvEach = wfvEachHere;
  wfvRises = wfvRisesHere;
#endif
}

void wfvWritePlane()
{
  wfvPlane = wfvT.xyz;
#if WFV_NON_CENTRAL || WFV_CURVED_RAYS
  wfvAnchor = wfvA;
#elif WFV_DOUBLES
  wfvOfPoints = wfvM;
#else
  wfvToward = wfvD;
  wfvMeets = wfvM;
#endif
}

void wfvWriteFlat()
{
  wfvEdge0 = wfvE[0];
  wfvEdge1 = wfvE[1];
  wfvEdge2 = wfvE[2];
  wfvWritePlane();
  wfvWriteRises();
#if WFV_MEETS_CHORDS
  wfvSlack = wfvSlackHere;
  wfvCorners01 = vec4(wfvC[0], wfvC[1]);
  wfvCorner2 = wfvC[2];
#if WFV_SEVERAL_CHORDS
  wfvCount = wfvCountHere;
  wfvPlace0 = wfvP[0];
  wfvPlace1 = wfvP[1];
  wfvPlace2 = wfvP[2];
#endif
#endif
#if WFV_CURVED_RAYS
  wfvDepths = wfvDepthsHere;
#endif
#if WFV_NON_CENTRAL
  wfvSpan0 = wfvSpans[0];
  wfvSpan1 = wfvSpans[1];
  wfvSpan2 = wfvSpans[2];
#endif
#if !WFV_EXACT
  wfvSlack = wfvS;
  wfvCorners01 = vec4(wfvC[0], wfvC[1]);
  wfvCorner2 = wfvC[2];
#if WFV_MERIDIAN && WFV_STRAIGHT_SEAM
  wfvSeam = wfvSeamPlaces;
#endif
#endif
#if !WFV_EXACT || WFV_DEBUG_VIEW
  wfvMode = wfvVertexMode;
#endif
}

#if WFV_RUNS > 1
// Of a triangle that is covered by columns (wfvEmitColumns) each run of the stage draws some; all of others
// is drawn by the first.
bool wfvMute = false;
#else
const bool wfvMute = false;
#endif

// Everything anew for each vertex: what was written before one was emitted is not kept.
void wfvWriteVertex(vec4 position, vec3 bary)
{
  gl_Position = position;
#if !WFV_EXACT
  wfvBary = bary;
  wfvPosition = bary.x * wfvP[0] + bary.y * wfvP[1] + bary.z * wfvP[2];
#endif
  // flat outputs count at a strip's third and later vertices only
  if (wfvEmitted > 1)
  {
    wfvWriteFlat();
    wfvWriteCorners();
    gl_PrimitiveID = gl_PrimitiveIDIn;
  }
}

void wfvEmitVertex(vec4 position, vec3 bary)
{
  if (wfvMute)
  {
    return;
  }
#if WFV_EMIT_PARTS > 1
  for (int i = wfvCopiesOfVertex(); i > 0; i--)
  {
    wfvWriteVertex(position, bary);
    EmitVertex();
  }
#else
  wfvWriteVertex(position, bary);
  EmitVertex();
#endif
  wfvEmitted++;
}

void wfvEndShape()
{
  EndPrimitive();
  wfvEmitted = 0;
#if WFV_EMIT_PARTS > 1
  wfvVertexOfStrip = 0;
#endif
}
