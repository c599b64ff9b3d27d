// SPDX-License-Identifier: BSD-3-Clause
// Source: Paul Bourke, "Mesh format for image warping",
// paulbourke.net/dataformats/meshwarp.
#include "FileText.h"
#include "Readers.h"

namespace wfv::displays
{
namespace
{
// Types of mesh, by the file's first line.
constexpr double Polar = 1;
constexpr double Rectangular = 2;
}

Calibration ReadBourke(const std::string& path, const std::string& bytes)
{
  Lines lines(path, bytes);
  lines.Next();
  const double type = lines.Finite<1>("the type of the mesh: 1 (polar) or 2 (rectangular)")[0];
  if (type != Polar && type != Rectangular)
  {
    lines.Fail("is no type of mesh: 1 (polar) or 2 (rectangular)");
  }
  lines.Next();
  const auto [columns, rows] = GridSize(lines);
  Calibration calibration;
  calibration.Gamma = Calibration::ProjectorGamma; // colours of nodes multiply the picture's values
  calibration.Mesh.HalfHeights = true;
  std::vector<WarpNode>& nodes = calibration.Mesh.Nodes;
  nodes.reserve(std::min(columns * rows, bytes.size()));
  while (nodes.size() < columns * rows && lines.Next())
  {
    const std::array<double, 5> n = lines.Finite<5>("five numbers: x, y, u, v and intensity");
    nodes.push_back({ vec2(n[0], n[1]), vec3(n[2], n[3], 0), n[4] });
  }
  CheckNodeCount(path, nodes.size(), columns * rows);
  // a negative intensity takes a node out of the mesh
  AddGrid(
    calibration.Mesh, columns, rows, [](const WarpNode& n) { return n.Brightness >= 0; },
    type == Polar);
  CheckMesh(path, calibration);
  return calibration;
}
}
