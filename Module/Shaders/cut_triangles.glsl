// SPDX-License-Identifier: BSD-3-Clause
// Cuts triangles that are longer than their chords may be, and that nothing tears, into smaller ones.
// Each edge is cut into its own number of chords, so that no crack opens between neighbours.
layout(triangles) in;
layout(triangle_strip, max_vertices = WFV_CUT_VERTICES) out;

// Along an edge of so many chords the share at which it has a place, the nearest to one of `most`.
float wfvOnEdge(int at, int chords, int most)
{
  return float((2 * at * chords + most) / (2 * most)) / float(chords);
}

// weights: of the corners.
void wfvEmitWeighed(vec3 weights)
{
  gl_Position = wfvProjectVertex(weights.x * gl_in[0].gl_Position.xyz +
    weights.y * gl_in[1].gl_Position.xyz + weights.z * gl_in[2].gl_Position.xyz);
  wfvWriteMix(weights);
  gl_PrimitiveID = gl_PrimitiveIDIn;
  EmitVertex();
}
