// SPDX-License-Identifier: BSD-3-Clause
#include "FileText.h"
#include "ObjFile.h"
#include "Surface.h"

#include <algorithm>
#include <numeric>

namespace wfv::displays
{
namespace
{
constexpr std::size_t LeafTriangles = 4;

// Metres: a ray does not meet the triangle that it starts on.
constexpr double LeastDistance = 1e-9;

// Share of a triangle by which a ray may pass beside it: no ray slips through between two.
constexpr double EdgeShare = 1e-9;

struct Box
{
  vec3 Low{ Surface::Nowhere };
  vec3 High{ -Surface::Nowhere };

  void Add(const vec3& p)
  {
    this->Low = glm::min(this->Low, p);
    this->High = glm::max(this->High, p);
  }

  // Returns the distance at which a ray enters the box, or Nowhere.
  double Enter(const vec3& origin, const vec3& inverse) const
  {
    const vec3 a = (this->Low - origin) * inverse;
    const vec3 b = (this->High - origin) * inverse;
    double first = 0;
    double last = Surface::Nowhere;
    for (int i = 0; i < 3; i++)
    {
      if (!std::isnan(a[i] + b[i])) // a ray within the plane of a side
      {
        first = std::max(first, std::min(a[i], b[i]));
        last = std::min(last, std::max(a[i], b[i]));
      }
    }
    // (a rounding of each end)
    return first <= last * (1 + 1e-12) + 1e-12 ? first : Surface::Nowhere;
  }
};

struct Branch
{
  Box Bounds;
  std::size_t First = 0; // of a leaf's triangles; of a branch: its second child (the first is next)
  std::size_t Count = 0; // of triangles; 0: a branch
};

using Triangle = std::array<vec3, 3>;

double MeetTriangle(const Triangle& t, const vec3& origin, const vec3& direction)
{
  const vec3 e1 = t[1] - t[0];
  const vec3 e2 = t[2] - t[0];
  const vec3 p = glm::cross(direction, e2);
  const double det = glm::dot(e1, p);
  if (det == 0)
  {
    return Surface::Nowhere;
  }
  const vec3 s = origin - t[0];
  const vec3 q = glm::cross(s, e1);
  const double u = glm::dot(s, p) / det;
  const double v = glm::dot(direction, q) / det;
  const double distance = glm::dot(e2, q) / det;
  const bool inside = u >= -EdgeShare && v >= -EdgeShare && u + v <= 1 + EdgeShare;
  return inside && distance > LeastDistance ? distance : Surface::Nowhere;
}

class MeshSurface : public Surface
{
public:
  explicit MeshSurface(std::vector<Triangle> triangles)
    : Triangles(std::move(triangles))
  {
    this->Build(0, this->Triangles.size());
  }

  double Meet(const vec3& origin, const vec3& direction) const override
  {
    const vec3 inverse = 1. / direction;
    double nearest = Nowhere;
    std::vector<std::size_t> open{ 0 };
    while (!open.empty())
    {
      const std::size_t at = open.back();
      const Branch& branch = this->Branches[at];
      open.pop_back();
      if (branch.Bounds.Enter(origin, inverse) >= nearest)
      {
        continue;
      }
      for (std::size_t i = branch.First; i < branch.First + branch.Count; i++)
      {
        nearest = std::min(nearest, MeetTriangle(this->Triangles[i], origin, direction));
      }
      if (branch.Count == 0)
      {
        open.push_back(at + 1);
        open.push_back(branch.First);
      }
    }
    return nearest;
  }

private:
  // Halves the triangles along the longest side of their box.
  void Build(std::size_t first, std::size_t count)
  {
    const std::size_t at = this->Branches.size();
    this->Branches.emplace_back();
    Box box;
    for (std::size_t i = first; i < first + count; i++)
    {
      for (const vec3& corner : this->Triangles[i])
      {
        box.Add(corner);
      }
    }
    this->Branches[at].Bounds = box;
    if (count <= LeafTriangles)
    {
      this->Branches[at].First = first;
      this->Branches[at].Count = count;
      return;
    }
    const vec3 size = box.High - box.Low;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const auto begin = this->Triangles.begin() + static_cast<std::ptrdiff_t>(first);
    const auto half = static_cast<std::ptrdiff_t>(count / 2);
    std::nth_element(begin, begin + half, begin + static_cast<std::ptrdiff_t>(count),
      [axis](const Triangle& a, const Triangle& b) {
        return a[0][axis] + a[1][axis] + a[2][axis] < b[0][axis] + b[1][axis] + b[2][axis];
      });
    this->Build(first, count / 2);
    this->Branches[at].First = this->Branches.size();
    this->Build(first + count / 2, count - count / 2);
  }

  std::vector<Triangle> Triangles;
  std::vector<Branch> Branches;
};
}

std::unique_ptr<Surface> ReadSurface(const std::string& path)
{
  const ObjMesh obj = ReadObj(path, ReadBytes(path));
  std::vector<Triangle> triangles;
  triangles.reserve(obj.Triangles.size());
  for (const std::array<ObjCorner, 3>& c : obj.Triangles)
  {
    triangles.push_back(
      { { obj.Points[c[0].Point], obj.Points[c[1].Point], obj.Points[c[2].Point] } });
  }
  return std::make_unique<MeshSurface>(std::move(triangles));
}
}
