// SPDX-License-Identifier: BSD-3-Clause
// The shapes of a triangle in several parts, where all their vertices are more than one invocation
// may write: each invocation goes through all of them and emits its own stretch. The strips' triangles
// are counted by their last vertices, so that none is in two parts.
int wfvVertexOfAll = 0;   // in all strips
int wfvVertexOfStrip = 0;

// How often this part emits the next vertex.
int wfvCopiesOfVertex()
{
  int first = (gl_InvocationID % WFV_EMIT_PARTS) * (WFV_EMIT_VERTICES - 3);
  int here = wfvVertexOfAll - first;
  // every second triangle of a strip turns the other way: a part that begins with such a one
  // begins with an empty one
  bool twice = here == 0 && (wfvVertexOfStrip & 1) == 1;
  wfvVertexOfAll++;
  wfvVertexOfStrip++;
  return here < 0 || here >= WFV_EMIT_VERTICES - 1 ? 0 : (twice ? 2 : 1);
}
