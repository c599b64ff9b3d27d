// SPDX-License-Identifier: BSD-3-Clause
// Pre-clip of triangles: writes the outputs of a vertex, and emits it.

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
