// SPDX-License-Identifier: BSD-3-Clause
// What rays in double ask of the tables of a direction map, which are in float32: the file's
// directions, to a ten-millionth.

dvec4 wfvFp64DirectionTexel(WfvFp64View v, int x, int y)
{
  return dvec4(wfvDirectionTexel(wfvView, x, y));
}

// Of functions that no ray needs.
dvec4 wfvFp64CellTexel(WfvFp64View v, int x, int y)
{
  return dvec4(wfvCellTexel(wfvView, x, y));
}

dvec4 wfvFp64SeedTexel(WfvFp64View v, int x, int y)
{
  return dvec4(wfvSeedTexel(wfvView, x, y));
}
