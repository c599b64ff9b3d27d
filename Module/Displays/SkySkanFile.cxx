// SPDX-License-Identifier: BSD-3-Clause
// The meshes of SkySkan (DigitalSky): lines "Name=number" of the view, a line "columns rows", a
// line "x y u v" a node. All are from above, 0 to 1; x or y of -1 takes a node out.
// Source: what SGCT reads (sgct/sgct, src/correction).
#include "FileText.h"
#include "Readers.h"

#include <algorithm>
#include <map>

namespace wfv::displays
{
namespace
{
// Height / width of the projectors for which the vertical angle is left out: 2048 x 1200 pixels.
constexpr double UsualShape = 1200. / 2048.;

using Settings = std::map<std::string, double>;

double Setting(const Settings& settings, const std::string& name, double otherwise)
{
  const auto found = settings.find(name);
  return found == settings.end() ? otherwise : found->second;
}

double Required(const std::string& path, const Settings& settings, const std::string& name)
{
  const double value = Setting(settings, name, std::nan(""));
  if (std::isnan(value))
  {
    throw FileError(path + " has no line '" + name + "='; a mesh of SkySkan needs it");
  }
  return value;
}

// "Name=number" of a line. False: it is another.
bool TakeSetting(const Lines& lines, Settings& settings)
{
  const std::string_view text = lines.Text();
  const std::size_t equals = text.find('=');
  if (equals == std::string_view::npos)
  {
    return false;
  }
  double value = 0;
  if (!Numbers(text.substr(equals + 1)).Next(value) || !std::isfinite(value))
  {
    lines.Fail("needs a number behind '='");
  }
  settings[LowerCase(Trimmed(text.substr(0, equals)))] = value;
  return true;
}

Frustum View(const std::string& path, const Settings& settings)
{
  double across = Required(path, settings, "horizontal fov");
  const double half = std::tan(glm::radians(across / 2));
  double up = Setting(settings, "vertical fov", 0);
  up = up > 0 ? up : glm::degrees(2 * std::atan(UsualShape * half));
  const double wider = Setting(settings, "horizontal tweak", 1);
  const double higher = Setting(settings, "vertical tweak", 1);
  across *= wider > 0 ? wider : 1;
  up *= higher > 0 ? higher : 1;
  Frustum frustum = FrustumOfAngles(-across / 2, across / 2, -up / 2, up / 2);
  CheckFrustum(path, frustum);
  frustum.Rotation = RotationAbout(1, -Required(path, settings, "dome azimuth")) *
    RotationAbout(0, Required(path, settings, "dome elevation"));
  return frustum;
}

// "x y u v" of a line.
WarpNode NodeOf(const Lines& lines)
{
  const std::array<double, 4> n = lines.Finite<4>("four numbers: x, y, u and v");
  const bool used = n[0] != -1 && n[1] != -1;
  const vec2 at = used ? vec2(2 * n[0] - 1, 1 - 2 * n[1]) : vec2(0);
  return { at, vec3(n[2], n[3], 0), used ? 1. : -1. };
}
}

Calibration ReadSkySkan(const std::string& path, const std::string& bytes)
{
  Lines lines(path, bytes);
  Settings settings;
  std::array<std::size_t, 2> size{ 0, 0 };
  Calibration calibration;
  std::vector<WarpNode>& nodes = calibration.Mesh.Nodes;
  while ((size[0] == 0 || nodes.size() < size[0] * size[1]) && lines.Next())
  {
    if (TakeSetting(lines, settings))
    {
      continue;
    }
    if (size[0] == 0)
    {
      size = GridSize(lines);
      continue;
    }
    nodes.push_back(NodeOf(lines));
  }
  CheckNodeCount(path, nodes.size(), std::max<std::size_t>(1, size[0] * size[1]));
  calibration.Content = View(path, settings);
  const double u = Setting(settings, "u tweak", 1);
  const double v = Setting(settings, "v tweak", 1);
  for (WarpNode& node : nodes)
  {
    node.Shown = vec3(node.Shown.x * (u > -1 ? u : 1), 1 - node.Shown.y * (v > -1 ? v : 1), 0);
  }
  AddGrid(calibration.Mesh, size[0], size[1], [](const WarpNode& n) { return n.Brightness >= 0; });
  CheckMesh(path, calibration);
  return calibration;
}
}
