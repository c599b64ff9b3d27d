// SPDX-License-Identifier: BSD-3-Clause
// The meshes of domeprojection: a line a node, "x;y;u;v;column;row", x and y from the upper left
// corner of the projector's picture, u and v from that of what it shows, 0 to 1.
// Source: what SGCT reads (sgct/sgct, src/correction).
#include "FileText.h"
#include "Readers.h"

#include <algorithm>

namespace wfv::displays
{
namespace
{
struct GridNode
{
  WarpNode Node;
  std::size_t Column;
  std::size_t Row;
};

std::vector<GridNode> ReadNodes(Lines& lines)
{
  std::vector<GridNode> nodes;
  while (lines.Next())
  {
    double first = 0;
    if (nodes.empty() && !Numbers(lines.Text(), ';').Next(first))
    {
      continue; // the heads of the columns
    }
    const std::array<double, 6> n =
      lines.Finite<6>("six numbers with semicolons between: x, y, u, v, column, row", ';');
    if (CountOf(n[4] + 1) == 0 || CountOf(n[5] + 1) == 0)
    {
      lines.Fail("has no column and row of a mesh: whole numbers from 0");
    }
    const vec2 at(std::clamp(n[0], 0., 1.), 1 - std::clamp(n[1], 0., 1.));
    nodes.push_back({ { 2. * at - 1., vec3(n[2], 1 - n[3], 0) }, static_cast<std::size_t>(n[4]),
      static_cast<std::size_t>(n[5]) });
  }
  return nodes;
}
}

Calibration ReadDomeprojection(const std::string& path, const std::string& bytes)
{
  Lines lines(path, bytes);
  std::vector<GridNode> nodes = ReadNodes(lines);
  const auto before = [](const GridNode& a, const GridNode& b) {
    return std::make_pair(a.Row, a.Column) < std::make_pair(b.Row, b.Column);
  };
  std::sort(nodes.begin(), nodes.end(), before);
  Calibration calibration;
  std::size_t columns = 0;
  while (columns < nodes.size() && nodes[columns].Row == nodes[0].Row)
  {
    columns++;
  }
  for (std::size_t i = 0; i < nodes.size(); i++)
  {
    const std::size_t row = nodes[0].Row + i / columns;
    const std::size_t column = nodes[0].Column + i % columns;
    if (nodes[i].Row != row || nodes[i].Column != column)
    {
      throw FileError(path + ": the node in column " + std::to_string(column) + " of row " +
        std::to_string(row) + " is missing or there twice; get the whole file");
    }
    calibration.Mesh.Nodes.push_back(nodes[i].Node);
  }
  if (columns < 2 || nodes.size() < 2 * columns || nodes.size() % columns != 0)
  {
    throw FileError(path + " has " + std::to_string(nodes.size()) +
      " nodes, which make no mesh: it is cut, or of another kind; get the whole file");
  }
  AddGrid(calibration.Mesh, columns, nodes.size() / columns);
  CheckMesh(path, calibration);
  return calibration;
}
}
