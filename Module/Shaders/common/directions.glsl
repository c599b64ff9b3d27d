// SPDX-License-Identifier: BSD-3-Clause
// The tables of a direction map (wfv::DirectionMap), as textures.
uniform sampler2D wfvDirections;
uniform sampler2D wfvCells;
uniform sampler2D wfvSeeds;

vec4 wfvDirectionTexel(WfvView v, int x, int y)
{
  return texelFetch(wfvDirections, ivec2(x, y), 0);
}

vec4 wfvCellTexel(WfvView v, int x, int y)
{
  return texelFetch(wfvCells, ivec2(x, y), 0);
}

vec4 wfvSeedTexel(WfvView v, int x, int y)
{
  return texelFetch(wfvSeeds, ivec2(x, y), 0);
}
