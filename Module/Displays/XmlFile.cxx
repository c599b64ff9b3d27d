// SPDX-License-Identifier: BSD-3-Clause
// SimCAD's files (Barco): GeometryFile > GeometryDefinition with X-FlatParameters and
// Y-FlatParameters, each a square of offsets divided by their attribute "range".
// Source: what SGCT reads (sgct/sgct, src/correction).
#include "FileText.h"
#include "Readers.h"
#include "ZipFile.h"

#include <pugixml.hpp>

#include <filesystem>

namespace wfv::displays
{
namespace
{
std::vector<double> Offsets(
  const std::string& path, const pugi::xml_node& definition, const char* name)
{
  const pugi::xml_node element = definition.child(name);
  const double range = element.attribute("range").as_double(1);
  if (!element || !(std::abs(range) > 0))
  {
    throw FileError(path + " has no element " + name + " with a range; check the file");
  }
  std::vector<double> values;
  Numbers numbers(element.child_value());
  for (double value = 0; numbers.Next(value) && std::isfinite(value);)
  {
    values.push_back(value / range);
  }
  if (!numbers.Remainder().empty())
  {
    throw FileError(path + ": number " + std::to_string(values.size() + 1) + " of " + name +
      " is none, or not finite; calibrate again");
  }
  return values;
}

Calibration ReadSimcad(const std::string& path, const pugi::xml_node& root)
{
  const pugi::xml_node definition = root.child("GeometryDefinition");
  const std::vector<double> across = Offsets(path, definition, "X-FlatParameters");
  const std::vector<double> down = Offsets(path, definition, "Y-FlatParameters");
  const auto side = static_cast<std::size_t>(std::lround(std::sqrt(double(across.size()))));
  if (side < 2 || side * side != across.size() || across.size() != down.size())
  {
    throw FileError(path + " has " + std::to_string(across.size()) + " and " +
      std::to_string(down.size()) + " offsets, which make no square mesh; get the whole file");
  }
  Calibration calibration;
  for (std::size_t i = 0; i < across.size(); i++)
  {
    const double last = double(side - 1);
    const vec2 uv(double(i % side) / last, 1 - double(i / side) / last);
    const vec2 at = uv + vec2(across[i], -down[i]);
    calibration.Mesh.Nodes.push_back({ 2. * at - 1., vec3(uv, 0) });
  }
  AddGrid(calibration.Mesh, side, side);
  CheckMesh(path, calibration);
  return calibration;
}
}

std::vector<Calibration> ReadXml(const std::string& path, const std::string& bytes)
{
  pugi::xml_document document;
  const pugi::xml_parse_result result = document.load_buffer(bytes.data(), bytes.size());
  if (!result)
  {
    throw FileError(path + ", byte " + std::to_string(result.offset) + ": " + result.description() +
      "; check the file");
  }
  const pugi::xml_node root = document.document_element();
  if (std::string(root.name()) == "GeometryFile")
  {
    return { ReadSimcad(path, root) };
  }
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  return ReadMpcdi(path, bytes, [&](const std::string& name) {
    if (PointsOutside(name))
    {
      throw FileError(path + ": '" + name + "' points outside of its folder");
    }
    return ReadBytes((folder / name).string());
  });
}
}
