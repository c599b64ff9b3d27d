// SPDX-License-Identifier: BSD-3-Clause
// The shapes of a triangle in several parts, where all their vertices are more than one invocation
// may write: each invocation goes through all of them and emits its own stretch. The strips' triangles
// are counted by their last vertices, so that none is in two parts.
int wfvVertexOfAll = 0;   // in all strips
int wfvVertexOfStrip = 0;

void wfvEmitOwnPart()
{
  int first = (gl_InvocationID % WFV_PARTS) * (WFV_PART_VERTICES - 3);
  int here = wfvVertexOfAll - first;
  if (here >= 0 && here < WFV_PART_VERTICES - 1)
  {
    // every second triangle of a strip turns the other way: a part that begins with such a one
    // begins with an empty one
    if (here == 0 && (wfvVertexOfStrip & 1) == 1)
    {
      vec4 position = gl_Position;
      EmitVertex();
      gl_Position = position;
    }
    EmitVertex();
  }
  wfvVertexOfAll++;
  wfvVertexOfStrip++;
}

void wfvEndOwnPart()
{
  EndPrimitive();
  wfvVertexOfStrip = 0;
}
#define EmitVertex() wfvEmitOwnPart()
#define EndPrimitive() wfvEndOwnPart()
