// SPDX-License-Identifier: BSD-3-Clause
#include "Readers.h"

namespace wfv::displays
{
namespace
{
// Share of a mesh's area that may be mirrored beside the rest: noise, and nodes that a program
// moved to the border of the picture. More is a fold.
constexpr double NoiseShare = 0.01;

double Area(vec2 a, vec2 b, vec2 c)
{
  return 0.5 * ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
}

// Triangles that show the picture one way round.
struct Side
{
  double Area = 0;       // in the projector's picture, square NDC
  std::size_t First = 0; // triangle, from 1; 0: none
};

// Adds a triangle to those that show the picture as it is, or to those that mirror it.
void AddTo(std::array<Side, 2>& sides, const WarpMesh& mesh, std::size_t i)
{
  const WarpNode& a = mesh.Nodes[mesh.Triangles[i][0]];
  const WarpNode& b = mesh.Nodes[mesh.Triangles[i][1]];
  const WarpNode& c = mesh.Nodes[mesh.Triangles[i][2]];
  const double at = Area(a.At, b.At, c.At);
  const double shown = Area(vec2(a.Shown), vec2(b.Shown), vec2(c.Shown));
  if (at != 0 && shown != 0)
  {
    Side& side = sides[(at > 0) == (shown > 0) ? 0 : 1];
    side.Area += std::abs(at);
    side.First = side.First == 0 ? i + 1 : side.First;
  }
}

void CheckNodes(const std::string& path, const WarpMesh& mesh, std::size_t i)
{
  for (const std::uint32_t node : mesh.Triangles[i])
  {
    if (node >= mesh.Nodes.size())
    {
      throw FileError(path + ": triangle " + std::to_string(i + 1) + " has the node " +
        std::to_string(node) + ", but there are " + std::to_string(mesh.Nodes.size()) +
        "; check the file");
    }
  }
}
}

void AddGrid(WarpMesh& mesh, std::size_t columns, std::size_t rows,
  const std::function<bool(const WarpNode&)>& used, bool wraps)
{
  const auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
    if (!used || (used(mesh.Nodes[a]) && used(mesh.Nodes[b]) && used(mesh.Nodes[c])))
    {
      mesh.Triangles.push_back({ { static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b),
        static_cast<std::uint32_t>(c) } });
    }
  };
  mesh.Triangles.reserve(2 * columns * rows);
  for (std::size_t row = 0; row + 1 < rows; row++)
  {
    for (std::size_t column = 0; column + (wraps ? 0 : 1) < columns; column++)
    {
      const std::size_t next = (column + 1) % columns;
      const std::size_t here = row * columns;
      const std::size_t above = here + columns;
      add(here + column, here + next, above + next);
      add(here + column, above + next, above + column);
    }
  }
}

void CheckMesh(const std::string& path, Calibration& calibration)
{
  const WarpMesh& mesh = calibration.Mesh;
  std::array<Side, 2> sides;
  for (std::size_t i = 0; i < mesh.Triangles.size(); i++)
  {
    CheckNodes(path, mesh, i);
    AddTo(sides, mesh, i);
  }
  const Side& fewer = sides[0].Area < sides[1].Area ? sides[0] : sides[1];
  const double all = sides[0].Area + sides[1].Area;
  if (!(all > 0))
  {
    throw FileError(path + ": no triangle of the mesh has an area; check the file");
  }
  if (fewer.First == 0)
  {
    return;
  }
  const std::string folded = path + ": the mesh folds at triangle " + std::to_string(fewer.First) +
    ", node " + std::to_string(mesh.Triangles[fewer.First - 1][0] + 1);
  if (fewer.Area > NoiseShare * all)
  {
    throw FileError(folded + ": part of it shows the picture mirrored; calibrate again");
  }
  calibration.Notes.push_back(folded + ", as noise of a measurement is");
}

vec3 Frustum::DirectionAt(vec2 uv) const
{
  const vec3 plane(this->Left + uv.x * (this->Right - this->Left),
    this->Down + uv.y * (this->Up - this->Down), -1);
  return glm::normalize(this->Rotation * (this->PlaneDistance * plane) + this->PlaneShift);
}

Frustum FrustumOfAngles(double left, double right, double down, double up)
{
  const auto tangent = [](double degrees) {
    return std::abs(degrees) < 90 ? std::tan(glm::radians(degrees)) : std::nan("");
  };
  Frustum frustum;
  frustum.Left = tangent(left);
  frustum.Right = tangent(right);
  frustum.Down = tangent(down);
  frustum.Up = tangent(up);
  return frustum;
}

void CheckFrustum(const std::string& path, const Frustum& f)
{
  if (!(f.Left < f.Right && f.Down < f.Up)) // nor NaN
  {
    throw FileError(path + ": its angles make no picture: left and down must be less than right " +
      "and up, and all between -90 and 90 degrees");
  }
}

glm::dmat3 RotationAbout(int axis, double degrees)
{
  const double c = std::cos(glm::radians(degrees));
  const double s = std::sin(glm::radians(degrees));
  const int y = (axis + 1) % 3;
  const int z = (axis + 2) % 3;
  glm::dmat3 m(1); // columns first
  m[y][y] = c;
  m[y][z] = s;
  m[z][y] = -s;
  m[z][z] = c;
  return m;
}
}
