// SPDX-License-Identifier: BSD-3-Clause
// A triangle as a grid: rows of strips.
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

void main()
{
  ivec3 chords = clamp(wfvReadChords(), 1, WFV_MOST_CHORDS);
  int most = max(chords.x, max(chords.y, chords.z));
  for (int j = 0; j < most; j++)
  {
    for (int i = 0; i < most - j; i++)
    {
      wfvEmitWeighed(wfvNode(i, j, chords, most));
      wfvEmitWeighed(wfvNode(i, j + 1, chords, most));
    }
    wfvEmitWeighed(wfvNode(most - j, j, chords, most));
    EndPrimitive();
  }
}
