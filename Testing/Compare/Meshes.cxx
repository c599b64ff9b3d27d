// SPDX-License-Identifier: BSD-3-Clause
#include "Meshes.h"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <array>
#include <map>
#include <vector>

namespace wfv
{
namespace test
{
namespace
{
// Points and triangles on their way to a polydata; equal points become one.
class MeshMaker
{
public:
  explicit MeshMaker(const Placement& where)
    : Where(where)
  {
    this->Points->SetDataType(where.Double ? VTK_DOUBLE : VTK_FLOAT);
  }

  vtkIdType Point(const vec3& p)
  {
    const vec3 q = this->Where.Centre + p * this->Where.Scale;
    return this->Points->InsertNextPoint(q.x, q.y, q.z);
  }

  void Triangle(vtkIdType a, vtkIdType b, vtkIdType c) { this->Cells->InsertNextCell({ a, b, c }); }

  void Quad(vtkIdType a, vtkIdType b, vtkIdType c, vtkIdType d)
  {
    this->Triangle(a, b, c);
    this->Triangle(a, c, d);
  }

  void Strip(const std::vector<vtkIdType>& points)
  {
    this->Strips->InsertNextCell(static_cast<vtkIdType>(points.size()), points.data());
  }

  // A cone: its rim, closed, and its tip.
  void Cone(const std::vector<vtkIdType>& rim, vtkIdType tip)
  {
    for (std::size_t i = 0; i < rim.size(); ++i)
    {
      this->Triangle(rim[i], rim[(i + 1) % rim.size()], tip);
    }
  }

  vtkSmartPointer<vtkPolyData> Finish()
  {
    auto mesh = vtkSmartPointer<vtkPolyData>::New();
    mesh->SetPoints(this->Points);
    mesh->SetPolys(this->Cells);
    if (this->Strips->GetNumberOfCells() > 0)
    {
      mesh->SetStrips(this->Strips);
    }
    return mesh;
  }

private:
  Placement Where;
  vtkNew<vtkPoints> Points;
  vtkNew<vtkCellArray> Cells;
  vtkNew<vtkCellArray> Strips;
};

// The point (i, j) of a face of the room; axis 0, 1, 2 and sign say which.
std::array<int, 3> RoomKey(int axis, int sign, int i, int j, int n)
{
  std::array<int, 3> key;
  key[axis] = sign > 0 ? n : 0;
  key[(axis + 1) % 3] = i;
  key[(axis + 2) % 3] = j;
  return key;
}
}

vtkSmartPointer<vtkPolyData> MakeGlobe(int n, const Placement& where)
{
  MeshMaker mesh(where);
  std::map<std::array<int, 3>, vtkIdType> ids;
  const auto id = [&](int x, int y, int z) {
    const auto found = ids.find({ { x, y, z } });
    if (found != ids.end())
    {
      return found->second;
    }
    return ids[{ { x, y, z } }] = mesh.Point(glm::normalize(vec3(x, y, z)));
  };
  for (int octant = 0; octant < 8; ++octant)
  {
    const int sx = octant & 1 ? -1 : 1;
    const int sy = octant & 2 ? -1 : 1;
    const int sz = octant & 4 ? -1 : 1;
    const auto at = [&](int i, int j) { return id(sx * i, sy * j, sz * (n - i - j)); };
    for (int i = 0; i < n; ++i)
    {
      for (int j = 0; i + j < n; ++j)
      {
        mesh.Triangle(at(i, j), at(i + 1, j), at(i, j + 1));
        if (i + j + 1 < n)
        {
          mesh.Triangle(at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
        }
      }
    }
  }
  return mesh.Finish();
}

vtkSmartPointer<vtkPolyData> MakeRoom(int n, const Placement& where)
{
  MeshMaker mesh(where);
  std::map<std::array<int, 3>, vtkIdType> ids;
  const auto coordinate = [n](int i) {
    const int c = 2 * i - n; // symmetric, so that opposite walls match to the bit
    return std::abs(c) == n ? c / double(n) : std::tan(0.25 * WFV_PI * c / n);
  };
  const auto id = [&](int axis, int sign, int i, int j) {
    const std::array<int, 3> key = RoomKey(axis, sign, i, j, n);
    const auto found = ids.find(key);
    if (found != ids.end())
    {
      return found->second;
    }
    const vtkIdType fresh =
      mesh.Point(vec3(coordinate(key[0]), coordinate(key[1]), coordinate(key[2])));
    ids[key] = fresh;
    return fresh;
  };
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int sign : { -1, 1 })
    {
      for (int i = 0; i < n; ++i)
      {
        for (int j = 0; j < n; ++j)
        {
          mesh.Quad(id(axis, sign, i, j), id(axis, sign, i + 1, j), id(axis, sign, i + 1, j + 1),
            id(axis, sign, i, j + 1));
        }
      }
    }
  }
  return mesh.Finish();
}

vtkSmartPointer<vtkPolyData> MakeSplinter(double aside, double below)
{
  MeshMaker mesh({});
  const vtkIdType right = mesh.Point(vec3(aside < 0 ? -1 : 1, 0, 0));
  const vtkIdType left = mesh.Point(vec3(aside < 0 ? 1 : -1, 0, 0));
  const vtkIdType top = mesh.Point(vec3(0, 1, 0));
  const vtkIdType pole = mesh.Point(vec3(0, -1, 0));
  const vtkIdType back = mesh.Point(vec3(0, 0, 1));
  const vtkIdType ahead = mesh.Point(vec3(0, 0, -1));
  const double level = std::cos(below);
  const vtkIdType beside =
    mesh.Point(vec3(std::sin(aside) * level, -std::sin(below), -std::cos(aside) * level));
  for (const vtkIdType side : { right, left })
  {
    mesh.Triangle(side, top, back);
    mesh.Triangle(side, top, ahead);
    mesh.Triangle(side, pole, back);
  }
  mesh.Triangle(left, pole, ahead);
  mesh.Triangle(beside, pole, ahead);
  mesh.Triangle(beside, right, pole);
  mesh.Triangle(beside, right, ahead);
  return mesh.Finish();
}

namespace
{
// A circle round y.
std::vector<vtkIdType> AddRing(MeshMaker& mesh, int steps, double y, double radius)
{
  std::vector<vtkIdType> ring;
  for (int i = 0; i < steps; ++i)
  {
    const double angle = 2 * WFV_PI * i / steps;
    ring.push_back(mesh.Point(vec3(radius * std::sin(angle), y, -radius * std::cos(angle))));
  }
  return ring;
}
}

vtkSmartPointer<vtkPolyData> MakeTube(int sides, const Placement& where)
{
  constexpr double Radius = 0.4;
  constexpr double Half = 0.8;
  MeshMaker mesh(where);
  const std::vector<vtkIdType> low = AddRing(mesh, sides, -Half, Radius);
  const std::vector<vtkIdType> high = AddRing(mesh, sides, Half, Radius);
  for (int i = 0; i < sides; ++i)
  {
    const int next = (i + 1) % sides;
    mesh.Quad(low[i], low[next], high[next], high[i]);
  }
  mesh.Cone(low, mesh.Point(vec3(0, -1, 0)));
  mesh.Cone(high, mesh.Point(vec3(0, 1, 0)));
  return mesh.Finish();
}

vtkSmartPointer<vtkPolyData> MakeHills(int rows, const Placement& where)
{
  MeshMaker mesh(where);
  const int steps = 2 * rows;
  std::vector<std::vector<vtkIdType>> rings;
  for (int j = 1; j < rows; ++j)
  {
    const double latitude = WFV_PI * j / rows - WFV_PI / 2;
    std::vector<vtkIdType> ring;
    for (int i = 0; i < steps; ++i)
    {
      const double longitude = 2 * WFV_PI * i / steps;
      const double far =
        0.85 + 0.15 * std::sin(7 * longitude) * std::cos(9 * latitude) * std::cos(latitude);
      ring.push_back(mesh.Point(far *
        vec3(std::cos(latitude) * std::sin(longitude), std::sin(latitude),
          -std::cos(latitude) * std::cos(longitude))));
    }
    rings.push_back(ring);
  }
  for (std::size_t j = 0; j + 1 < rings.size(); ++j)
  {
    std::vector<vtkIdType> strip;
    for (int i = 0; i <= steps; ++i)
    {
      strip.push_back(rings[j][i % steps]);
      strip.push_back(rings[j + 1][i % steps]);
    }
    mesh.Strip(strip);
  }
  mesh.Cone(rings.front(), mesh.Point(vec3(0, -0.85, 0)));
  mesh.Cone(rings.back(), mesh.Point(vec3(0, 0.85, 0)));
  return mesh.Finish();
}

double LongestEdge(const reference::TriangleSoup& soup, double nearRadius)
{
  double longest = 0;
  for (const auto& t : soup.Triangles)
  {
    for (int k = 0; k < 3; ++k)
    {
      const vec3 a = soup.Points[t[k]];
      const vec3 b = soup.Points[t[(k + 1) % 3]];
      if (glm::length(a) > nearRadius && glm::length(b) > nearRadius)
      {
        longest = std::max(longest, std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)));
      }
    }
  }
  return longest * 180 / WFV_PI;
}
}
}
