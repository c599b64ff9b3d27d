// SPDX-License-Identifier: BSD-3-Clause
// What rays in double ask of the tables of a direction map, which are in float32: the file's
// directions, to a ten-millionth.

dvec4 wfvWholeDirectionTexel(WfvWholeView v, int x, int y)
{
  return dvec4(wfvDirectionTexel(wfvView, x, y));
}

// Of functions that no ray needs.
dvec4 wfvWholeCellTexel(WfvWholeView v, int x, int y)
{
  return dvec4(wfvCellTexel(wfvView, x, y));
}

dvec4 wfvWholeSeedTexel(WfvWholeView v, int x, int y)
{
  return dvec4(wfvSeedTexel(wfvView, x, y));
}
