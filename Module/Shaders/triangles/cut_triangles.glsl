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

// One of whose edges has one chord, as a strip of so many rows from that edge to the corner opposite.
void wfvEmitStrip(ivec3 chords, int rows)
{
  // corner i is opposite to that edge; j and k are its ends
  int i = chords.x == 1 ? 0 : chords.y == 1 ? 1 : 2;
  int j = i == 2 ? 0 : i + 1;
  int k = i == 0 ? 2 : i - 1;
  for (int row = 0; row < rows; row++)
  {
    // the last place passed on either edge: the next one might be the corner already, and what is
    // then left of the other edge would be drawn from there, turned round where that edge is hollow
    float onJ = wfvOnEdge(row * chords[k] / rows, chords[k]); // edge k is that from i to j
    float onK = wfvOnEdge(row * chords[j] / rows, chords[j]);
    vec3 weights = vec3(0.0);
    weights[j] = 1.0 - onJ;
    weights[i] = onJ;
    wfvEmitWeighed(weights);
    weights = vec3(0.0);
    weights[k] = 1.0 - onK;
    weights[i] = onK;
    wfvEmitWeighed(weights);
  }
  if (rows > 0)
  {
    vec3 end = vec3(0.0);
    end[i] = 1.0;
    wfvEmitWeighed(end);
    EndPrimitive();
  }
}

// The share of an edge at the nearest of its own places to one of `most`.
float wfvNearestOnEdge(int at, int chords, int most)
{
  return wfvOnEdge((2 * at * chords + most) / (2 * most), chords);
}

// The weights of the corners at a grid's node, on an edge at one of its own.
vec3 wfvNode(int i, int j, ivec3 chords, int most)
{
  vec3 w = vec3(most - i - j, j, i) / float(most);
  if (i + j == most)
  {
    float share = wfvNearestOnEdge(j, chords.x, most);
    w = vec3(0.0, share, 1.0 - share);
  }
  else if (j == 0)
  {
    float share = wfvNearestOnEdge(i, chords.y, most);
    w = vec3(1.0 - share, 0.0, share);
  }
  else if (i == 0)
  {
    float share = wfvNearestOnEdge(most - j, chords.z, most);
    w = vec3(share, 1.0 - share, 0.0);
  }
  return w;
}

// Another as a grid: so many rows of strips.
void wfvEmitGrid(ivec3 chords, int rows)
{
  for (int j = 0; j < rows; j++)
  {
    for (int i = 0; i < rows - j; i++)
    {
      wfvEmitWeighed(wfvNode(i, j, chords, rows));
      wfvEmitWeighed(wfvNode(i, j + 1, chords, rows));
    }
    wfvEmitWeighed(wfvNode(rows - j, j, chords, rows));
    EndPrimitive();
  }
}

void main()
{
  ivec3 chords = max(wfvReadChords(), 1);
  int most = max(chords.x, max(chords.y, chords.z));
  bool strip = min(chords.x, min(chords.y, chords.z)) == 1;
  // (a loop of no rows ends at once, where software rendering would run through both sides of a branch)
  wfvEmitStrip(chords, strip ? most : 0);
  wfvEmitGrid(chords, strip ? 0 : most);
}
