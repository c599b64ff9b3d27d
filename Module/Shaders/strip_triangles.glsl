// SPDX-License-Identifier: BSD-3-Clause
// A long triangle, one of whose edges is short, as a strip from that edge to the corner opposite.
void main()
{
  ivec3 chords = clamp(wfvReadChords(), 1, WFV_MOST_CHORDS);
  // corner i is opposite to the short edge; j and k are its ends
  int i = chords.x == 1 ? 0 : chords.y == 1 ? 1 : 2;
  int j = i == 2 ? 0 : i + 1;
  int k = i == 0 ? 2 : i - 1;
  int most = max(chords[j], chords[k]);
  for (int row = 0; row < most; row++)
  {
    // the last place passed on either edge: the next one might be the corner already, and what is
    // then left of the other edge would be drawn from there, turned round where that edge is hollow
    float onJ = wfvOnEdge(row * chords[k] / most, chords[k]); // edge k is that from i to j
    float onK = wfvOnEdge(row * chords[j] / most, chords[j]);
    vec3 weights = vec3(0.0);
    weights[j] = 1.0 - onJ;
    weights[i] = onJ;
    wfvEmitWeighed(weights);
    weights = vec3(0.0);
    weights[k] = 1.0 - onK;
    weights[i] = onK;
    wfvEmitWeighed(weights);
  }
  vec3 end = vec3(0.0);
  end[i] = 1.0;
  wfvEmitWeighed(end);
  EndPrimitive();
}
