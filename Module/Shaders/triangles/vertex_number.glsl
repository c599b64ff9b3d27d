// SPDX-License-Identifier: BSD-3-Clause
// Gives the number of a vertex in its mapper. A piece of a refined triangle has new vertices: each
// says the number of a corner of its triangle.

in vec2 wfvVertex; // the number's lower 16 bits; the others, plus 1; 0, 0: the mapper's own vertex

int wfvVertexNumber()
{
  return wfvVertex.y > 0.0 ? int(wfvVertex.x) + 65536 * (int(wfvVertex.y) - 1) : gl_VertexID;
}
