// SPDX-License-Identifier: BSD-3-Clause
// Cuts triangles that are longer than their chords may be, and meet no discontinuity, into smaller ones.
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
#if WFV_SEEN_VERTICES
  gl_Position = wfvProjectVertex(wfvSeenVertex(vec4(wfvMix(weights), 1.0)).xyz);
#else
  gl_Position = wfvProjectVertex(wfvMix(weights));
#endif
  wfvWriteMix(weights);
  gl_PrimitiveID = gl_PrimitiveIDIn;
  EmitVertex();
}

// The share of an edge at the place before, or the nearest, of its own places to one of `most`.
float wfvNearOnEdge(int at, int chords, int most, bool before)
{
  return wfvOnEdge((2 * at * chords + (before ? 0 : most)) / (2 * most), chords);
}

// Of a triangle one of whose edges has one chord: the weights of the corners on a row from that edge to the
// corner opposite, on either side.
vec3 wfvOnStrip(int row, bool left, ivec3 chords, int rows)
{
  // corner i is opposite to that edge; j and k are its ends
  int i = chords.x == 1 ? 0 : chords.y == 1 ? 1 : 2;
  int j = i == 2 ? 0 : i + 1;
  int k = i == 0 ? 2 : i - 1;
  // the last place passed on either edge: the next one might be the corner already, and what is
  // then left of the other edge would be drawn from there, turned round where that edge is hollow
  float share = wfvNearOnEdge(row, left ? chords[k] : chords[j], rows, true); // edge k is from i to j
  vec3 weights = vec3(0.0);
  weights[left ? j : k] = 1.0 - share;
  weights[i] = share;
  return weights;
}

// Of another one: the weights at a node of a grid, on an edge at one of its own places.
vec3 wfvNode(int i, int j, ivec3 chords, int most)
{
  bool first = i + j == most;
  bool second = !first && j == 0;
  int at = first ? j : second ? i : most - j;
  float share = wfvNearOnEdge(at, first ? chords.x : second ? chords.y : chords.z, most, false);
  float rest = 1.0 - share;
  return first ? vec3(0.0, share, rest)
    : second   ? vec3(rest, 0.0, share)
    : i == 0   ? vec3(share, rest, 0.0)
               : vec3(most - i - j, j, i) / float(most);
}

// A strip of so many rows, the last of which is a corner, or a part of it; or a grid, so many rows of
// strips. One text emits them all, for where all is inlined text is what compilers take long for.
void main()
{
  ivec3 chords = max(wfvReadChords(), 1);
  int most = max(chords.x, max(chords.y, chords.z));
  bool strip = min(chords.x, min(chords.y, chords.z)) == 1;
  int first = strip ? wfvPartInCode(wfvReadCode()) * WFV_ROWS_OF_PART : 0;
  for (int j = 0; j < (strip ? 1 : most); j++)
  {
    // a part that goes on ends with both ends of its last row
    bool goesOn = strip && first + WFV_ROWS_OF_PART < most;
    int last = goesOn ? 2 * (first + WFV_ROWS_OF_PART) + 1 : 2 * (strip ? most : most - j);
    for (int v = 2 * first; v <= last; v++)
    {
      bool left = (v & 1) == 0;
      wfvEmitWeighed(strip ? wfvOnStrip(v / 2, left, chords, most)
                           : wfvNode(v / 2, left ? j : j + 1, chords, most));
    }
    EndPrimitive();
  }
}
