// SPDX-License-Identifier: BSD-3-Clause
// Source: Wavefront, "Advanced Visualizer" manual, appendix B1: object files (.obj).
#include "ObjFile.h"

#include "FileText.h"
#include "Readers.h"

#include <charconv>
#include <map>

namespace wfv::displays
{
namespace
{
// An index of the file, from 1, or from the end where it is negative, to one from 0.
std::uint32_t Index(const Lines& lines, std::string_view text, std::size_t count)
{
  long long index = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), index);
  const long long from0 = index < 0 ? static_cast<long long>(count) + index : index - 1;
  if (error != std::errc() || end != text.data() + text.size() || index == 0 || from0 < 0 ||
    from0 >= static_cast<long long>(count))
  {
    lines.Fail("'" + std::string(text) + "' is none of the " + std::to_string(count) +
      " points or texture coordinates before");
  }
  return static_cast<std::uint32_t>(from0);
}

// A corner is "point", "point/texture", "point//normal" or all three.
ObjCorner Corner(const Lines& lines, std::string_view text, const ObjMesh& mesh)
{
  const std::size_t slash = std::min(text.find('/'), text.size());
  ObjCorner corner{ Index(lines, text.substr(0, slash), mesh.Points.size()), ObjMesh::NoTexture };
  if (slash < text.size())
  {
    const std::string_view rest = text.substr(slash + 1);
    const std::string_view texture = rest.substr(0, rest.find('/'));
    if (!texture.empty())
    {
      corner.Texture = Index(lines, texture, mesh.Textures.size());
    }
  }
  return corner;
}

void AddFace(const Lines& lines, std::string_view text, ObjMesh& mesh)
{
  std::vector<ObjCorner> corners;
  while (!text.empty())
  {
    const std::size_t end = std::min(text.find_first_of(" \t"), text.size());
    corners.push_back(Corner(lines, text.substr(0, end), mesh));
    text = Trimmed(text.substr(end));
  }
  if (corners.size() < 3)
  {
    lines.Fail("a face needs three corners");
  }
  for (std::size_t i = 2; i < corners.size(); i++)
  {
    mesh.Triangles.push_back({ { corners[0], corners[i - 1], corners[i] } });
  }
}

// The first two or three numbers behind a keyword; a fourth one is a weight or a colour.
template <std::size_t N>
std::array<double, N> Coordinates(const Lines& lines, std::string_view text)
{
  std::array<double, N> values{};
  Numbers numbers(text);
  bool good = numbers.All(values);
  for (const double value : values)
  {
    good = good && std::isfinite(value);
  }
  if (!good)
  {
    lines.Fail("needs " + std::to_string(N) + " numbers");
  }
  return values;
}
}

ObjMesh ReadObj(const std::string& path, const std::string& bytes)
{
  ObjMesh mesh;
  Lines lines(path, bytes);
  while (lines.Next())
  {
    const std::string_view text = lines.Text();
    const std::size_t end = std::min(text.find_first_of(" \t"), text.size());
    const std::string_view word = text.substr(0, end);
    const std::string_view rest = Trimmed(text.substr(end));
    if (word == "v")
    {
      const std::array<double, 3> p = Coordinates<3>(lines, rest);
      mesh.Points.emplace_back(p[0], p[1], p[2]);
    }
    else if (word == "vt")
    {
      const std::array<double, 2> t = Coordinates<2>(lines, rest);
      mesh.Textures.emplace_back(t[0], t[1]);
    }
    else if (word == "f")
    {
      AddFace(lines, rest, mesh);
    }
  }
  if (mesh.Triangles.empty())
  {
    throw FileError(path + " has no face: it is cut, or no OBJ; check the file");
  }
  return mesh;
}

Calibration ReadObjWarp(const std::string& path, const std::string& bytes)
{
  const ObjMesh obj = ReadObj(path, bytes);
  const bool paired = obj.Points.size() == obj.Textures.size();
  Calibration calibration;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> nodes;
  for (const std::array<ObjCorner, 3>& corners : obj.Triangles)
  {
    std::array<std::uint32_t, 3> triangle{};
    for (int i = 0; i < 3; i++)
    {
      ObjCorner corner = corners[i];
      if (corner.Texture == ObjMesh::NoTexture)
      {
        if (!paired)
        {
          throw FileError(path + " has " + std::to_string(obj.Points.size()) + " points and " +
            std::to_string(obj.Textures.size()) +
            " texture coordinates; a warp mesh needs one a point, or faces that name both");
        }
        corner.Texture = corner.Point;
      }
      const auto next = static_cast<std::uint32_t>(calibration.Mesh.Nodes.size());
      const auto [found, isNew] = nodes.emplace(std::make_pair(corner.Point, corner.Texture), next);
      if (isNew)
      {
        calibration.Mesh.Nodes.push_back(
          { vec2(obj.Points[corner.Point]), vec3(obj.Textures[corner.Texture], 0) });
      }
      triangle[i] = found->second;
    }
    calibration.Mesh.Triangles.push_back(triangle);
  }
  CheckMesh(path, calibration);
  return calibration;
}
}
