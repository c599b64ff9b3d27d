// SPDX-License-Identifier: BSD-3-Clause
#include "Sphere.h"

#include <algorithm>

namespace wfv
{
namespace stress
{
namespace
{
vec3 AsFloat(const vec3& p)
{
  return vec3(float(p.x), float(p.y), float(p.z));
}

double SegmentDistance(const vec3& a, const vec3& b)
{
  const vec3 ab = b - a;
  const double t = std::clamp(-glm::dot(a, ab) / glm::dot(ab, ab), 0.0, 1.0);
  return glm::length(a + ab * t);
}

// From the origin to the nearest place of a triangle that faces it.
double NearestDistance(const vec3& a, const vec3& b, const vec3& c)
{
  const vec3 n = glm::cross(b - a, c - a);
  const vec3 foot = n * (glm::dot(a, n) / glm::dot(n, n));
  const bool inside = glm::dot(glm::cross(a, b), foot) >= 0 &&
    glm::dot(glm::cross(b, c), foot) >= 0 && glm::dot(glm::cross(c, a), foot) >= 0;
  return inside ? glm::length(foot)
                : std::min({ SegmentDistance(a, b), SegmentDistance(b, c), SegmentDistance(c, a) });
}
}

SphereMesh::SphereMesh(Random& random, double mostRadius, double thinnest)
  : MostRadius(mostRadius)
  , Thinnest(thinnest)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const double sign : { 1.0, -1.0 })
    {
      vec3 d(0);
      d[axis] = sign;
      this->AddPoint(random, d);
    }
  }
  for (int octant = 0; octant < 8; ++octant)
  {
    const vtkIdType x = octant & 1;
    const vtkIdType y = 2 + ((octant >> 1) & 1);
    const vtkIdType z = 4 + ((octant >> 2) & 1);
    const bool mirrored = ((octant & 1) + ((octant >> 1) & 1) + ((octant >> 2) & 1)) % 2 == 1;
    this->Replace({}, { mirrored ? Ids{ { y, x, z } } : Ids{ { x, y, z } } });
  }
}

double SphereMesh::Thickness(const Ids& t) const
{
  const vec3& a = this->Points[t[0]];
  const vec3& b = this->Points[t[1]];
  const vec3& c = this->Points[t[2]];
  return glm::dot(a, glm::cross(b, c)) / (glm::length(a) * glm::length(b) * glm::length(c));
}

vtkIdType SphereMesh::AddPoint(Random& random, const vec3& direction)
{
  this->Points.push_back(
    AsFloat(glm::normalize(direction) * random.Log(1, this->MostRadius * (1 + 1e-9))));
  return vtkIdType(this->Points.size()) - 1;
}

std::size_t SphereMesh::FindTriangle(const vec3& d) const
{
  for (std::size_t i = 0; i < this->Triangles.size(); ++i)
  {
    const Ids& t = this->Triangles[i];
    bool inside = true;
    for (int k = 0; k < 3 && inside; ++k)
    {
      inside = glm::dot(d, glm::cross(this->Points[t[k]], this->Points[t[(k + 1) % 3]])) >= 0;
    }
    if (inside)
    {
      return i;
    }
  }
  return 0;
}

// The fresh triangles in the place of the old ones; the first take their numbers.
bool SphereMesh::Replace(const std::vector<std::size_t>& old, const std::vector<Ids>& fresh)
{
  for (const Ids& t : fresh)
  {
    const bool near =
      NearestDistance(this->Points[t[0]], this->Points[t[1]], this->Points[t[2]]) < LeastDistance;
    if (near || !(this->Thickness(t) > this->Thinnest))
    {
      return false;
    }
  }
  for (const std::size_t i : old)
  {
    for (int k = 0; k < 3; ++k)
    {
      this->Edges.erase({ this->Triangles[i][k], this->Triangles[i][(k + 1) % 3] });
    }
  }
  for (std::size_t n = 0; n < fresh.size(); ++n)
  {
    const std::size_t i = n < old.size() ? old[n] : this->Triangles.size();
    this->Triangles.resize(std::max(this->Triangles.size(), i + 1));
    this->Triangles[i] = fresh[n];
    for (int k = 0; k < 3; ++k)
    {
      this->Edges[{ fresh[n][k], fresh[n][(k + 1) % 3] }] = i;
    }
  }
  return true;
}

std::size_t SphereMesh::Across(std::size_t triangle, int edge) const
{
  const Ids& t = this->Triangles[triangle];
  return this->Edges.at({ t[(edge + 1) % 3], t[edge] });
}

// The vertex of a triangle that is on neither end of an edge.
vtkIdType SphereMesh::Apex(std::size_t triangle, vtkIdType a, vtkIdType b) const
{
  for (const vtkIdType id : this->Triangles[triangle])
  {
    if (id != a && id != b)
    {
      return id;
    }
  }
  return -1;
}

void SphereMesh::SplitFace(Random& random, std::size_t triangle)
{
  const Ids t = this->Triangles[triangle];
  vec3 d(0);
  for (const vtkIdType id : t)
  {
    d += glm::normalize(this->Points[id]) * random.Log(1e-4, 1);
  }
  const vtkIdType n = this->AddPoint(random, d);
  if (!this->Replace({ triangle },
        { Ids{ { t[0], t[1], n } }, Ids{ { t[1], t[2], n } }, Ids{ { t[2], t[0], n } } }))
  {
    this->Points.pop_back();
  }
}

void SphereMesh::SplitEdge(Random& random, std::size_t triangle)
{
  const int edge = random.Below(3);
  const vtkIdType a = this->Triangles[triangle][edge];
  const vtkIdType b = this->Triangles[triangle][(edge + 1) % 3];
  const std::size_t other = this->Across(triangle, edge);
  const vtkIdType c = this->Apex(triangle, a, b);
  const vtkIdType d = this->Apex(other, a, b);
  const double share = random.Between(0.1, 0.9);
  const vec3 middle =
    glm::normalize(this->Points[a]) * share + glm::normalize(this->Points[b]) * (1 - share);
  const vtkIdType n = this->AddPoint(random, middle);
  if (!this->Replace({ triangle, other },
        { Ids{ { a, n, c } }, Ids{ { b, n, d } }, Ids{ { n, b, c } }, Ids{ { n, a, d } } }))
  {
    this->Points.pop_back();
  }
}

void SphereMesh::TurnEdge(std::size_t triangle, int edge)
{
  const vtkIdType a = this->Triangles[triangle][edge];
  const vtkIdType b = this->Triangles[triangle][(edge + 1) % 3];
  const std::size_t other = this->Across(triangle, edge);
  const vtkIdType c = this->Apex(triangle, a, b);
  const vtkIdType d = this->Apex(other, a, b);
  if (this->Edges.count({ c, d }) == 0 && this->Edges.count({ d, c }) == 0)
  {
    this->Replace({ triangle, other }, { Ids{ { a, d, c } }, Ids{ { d, b, c } } });
  }
}

void SphereMesh::Refine(Random& random)
{
  const std::size_t triangle = this->FindTriangle(random.Direction());
  const double what = random.Unit();
  if (what < 0.5)
  {
    this->SplitFace(random, triangle);
  }
  else if (what < 0.7)
  {
    this->SplitEdge(random, triangle);
  }
  this->TurnEdge(triangle, random.Below(3));
}
}
}
