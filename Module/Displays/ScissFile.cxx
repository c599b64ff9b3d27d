// SPDX-License-Identifier: BSD-3-Clause
// The meshes of SCISS (Uniview), little-endian: "SGC", a byte of the version, the kind of mapping,
// eleven floats of the view, two sizes, the nodes, the number of indices, the indices.
// Source: what SGCT reads (sgct/sgct, src/correction).
#include "FileText.h"
#include "Readers.h"

#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <cstring>

namespace wfv::displays
{
namespace
{
constexpr std::uint32_t Planar = 0; // the kind of mapping

// Takes numbers of four bytes from the front.
class Reader
{
public:
  Reader(const std::string& path, const std::string& bytes, std::size_t at)
    : Path(path)
    , Bytes(bytes)
    , At(at)
  {
  }

  std::uint32_t Whole()
  {
    if (this->Bytes.size() - this->At < 4)
    {
      throw FileError(this->Path + " ends at byte " + std::to_string(this->Bytes.size()) +
        ", within its mesh: it is cut; get the whole file");
    }
    std::uint32_t value = 0;
    for (std::size_t i = 4; i-- > 0;)
    {
      value = value << 8 | static_cast<unsigned char>(this->Bytes[this->At + i]);
    }
    this->At += 4;
    return value;
  }

  double Real()
  {
    const std::uint32_t bits = this->Whole();
    float value = 0;
    std::memcpy(&value, &bits, sizeof value);
    if (!std::isfinite(value))
    {
      throw FileError(this->Path + ": the number at byte " + std::to_string(this->At - 4) +
        " is not finite; calibrate again");
    }
    return value;
  }

private:
  const std::string& Path;
  const std::string& Bytes;
  std::size_t At;
};

Frustum ReadView(const std::string& path, Reader& reader)
{
  std::array<double, 11> v{}; // quaternion x y z w, position x y z, up, down, left, right
  std::generate(v.begin(), v.end(), [&] { return reader.Real(); });
  const glm::dquat turn(v[3], v[0], v[1], v[2]);
  Frustum frustum = FrustumOfAngles(v[9], v[10], v[8], v[7]);
  CheckFrustum(path, frustum);
  if (!(glm::length(turn) > 0))
  {
    throw FileError(path + ": the quaternion of its view is zero; calibrate again");
  }
  frustum.Rotation = glm::mat3_cast(glm::normalize(turn));
  return frustum;
}

void ReadNodes(Reader& reader, std::size_t count, WarpMesh& mesh)
{
  for (std::size_t i = 0; i < count; i++)
  {
    std::array<double, 6> n{}; // x y z of the picture from above, u v w
    std::generate(n.begin(), n.end(), [&] { return reader.Real(); });
    const auto unit = [](double x) { return std::clamp(x, 0., 1.); };
    const vec2 at(2 * unit(n[0]) - 1, 1 - 2 * unit(n[1]));
    mesh.Nodes.push_back({ at, vec3(unit(n[3]), unit(n[4]), 0) });
  }
}

// Every second triangle of a strip winds the other way, which CheckMesh does not mind.
void ReadTriangles(Reader& reader, bool strip, WarpMesh& mesh)
{
  const std::size_t count = reader.Whole();
  std::array<std::uint32_t, 3> t{};
  for (std::size_t i = 0; i < count; i++)
  {
    t = { { t[1], t[2], reader.Whole() } };
    const bool same = t[0] == t[1] || t[1] == t[2] || t[0] == t[2];
    if (i >= 2 && !same && (strip || i % 3 == 2))
    {
      mesh.Triangles.push_back(t);
    }
  }
}
}

Calibration ReadSciss(const std::string& path, const std::string& bytes)
{
  if (bytes.compare(0, 3, "SGC") != 0 || bytes.size() < 4)
  {
    throw FileError(path + " does not begin with SGC: it is no mesh of SCISS; check the file");
  }
  const bool second = bytes[3] == 2 || bytes[3] == '2';
  Reader reader(path, bytes, 4);
  if (reader.Whole() != Planar)
  {
    throw FileError(path + " is for the faces of a cube, which are not supported; export the " +
      "planar mapping");
  }
  Calibration calibration;
  calibration.Content = ReadView(path, reader);
  const std::size_t first = reader.Whole();
  const std::size_t last = reader.Whole();
  const std::size_t count = second ? last : first * last;
  if (count < 3 || first > LargestCount || last > LargestCount || count > bytes.size())
  {
    throw FileError(path + ": " + std::to_string(first) + " x " + std::to_string(last) +
      " is no size of its mesh; check the file");
  }
  ReadNodes(reader, count, calibration.Mesh);
  constexpr std::size_t lists = 4; // the first size, where the indices are no strip
  ReadTriangles(reader, !second || first != lists, calibration.Mesh);
  if (calibration.Mesh.Triangles.empty() && !second)
  {
    AddGrid(calibration.Mesh, first, last);
  }
  CheckMesh(path, calibration);
  return calibration;
}
}
