// SPDX-License-Identifier: BSD-3-Clause
// Cuts triangles that are longer than their chords may be, and that nothing tears, into smaller ones.
// Each edge is cut into its own number of chords, so that no crack opens between neighbours.
layout(triangles) in;
layout(triangle_strip, max_vertices = WFV_CUT_VERTICES) out;

// Shares are multiples of one over this: so a share and what is left of it add up to 1, from whichever
// end of an edge they are counted.
const float WFV_SHARES = 1048576.0;

// The share of an edge at one of the places that so many chords cut it at.
float wfvOnEdge(int at, int chords)
{
  return floor(float(at) / float(chords) * WFV_SHARES + 0.5) / WFV_SHARES;
}

// Of two corners, rounded alike whichever triangle asks.
vec3 wfvMixTwo(int i, int j, float weight)
{
  vec3 p = gl_in[i].gl_Position.xyz;
  vec3 q = gl_in[j].gl_Position.xyz;
  bool ordered = p.x != q.x ? p.x < q.x : (p.y != q.y ? p.y < q.y : p.z < q.z);
  return ordered ? weight * p + (1.0 - weight) * q : (1.0 - weight) * q + weight * p;
}

// weights: of the corners.
vec3 wfvMix(vec3 weights)
{
  if (weights.x == 0.0)
  {
    return wfvMixTwo(1, 2, weights.y);
  }
  if (weights.y == 0.0)
  {
    return wfvMixTwo(2, 0, weights.z);
  }
  if (weights.z == 0.0)
  {
    return wfvMixTwo(0, 1, weights.x);
  }
  return weights.x * gl_in[0].gl_Position.xyz + weights.y * gl_in[1].gl_Position.xyz +
    weights.z * gl_in[2].gl_Position.xyz;
}

void wfvEmitWeighed(vec3 weights)
{
  gl_Position = wfvProjectVertex(wfvMix(weights));
  wfvWriteMix(weights);
  gl_PrimitiveID = gl_PrimitiveIDIn;
  EmitVertex();
}
