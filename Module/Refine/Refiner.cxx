// SPDX-License-Identifier: BSD-3-Clause
#include "Refine/Refiner.h"

#include "Refine/Affine.h"
#include "Refine/EndCache.h"
#include "Refine/RefineSpace.h"
#include "Refine/Subdivision.h"

#include <cmath>

namespace wfv
{
bool RefineView::operator==(const RefineView& o) const
{
  const WfvView& a = this->View;
  const WfvView& b = o.View;
  return this->Map == o.Map && a.halfFov == b.halfFov && a.scale == b.scale && a.tilt == b.tilt &&
    a.radii == b.radii && a.lens == b.lens && a.lens5 == b.lens5 && a.lensHigh == b.lensHigh &&
    a.center == b.center && a.maxAngle == b.maxAngle && a.map == b.map && a.eye == b.eye &&
    a.halfEyes == b.halfEyes && a.stereo == b.stereo && a.depthMapping == b.depthMapping &&
    this->Part.Low == o.Part.Low && this->Part.High == o.Part.High && this->Limits == o.Limits &&
    this->Pixels == o.Pixels && this->Tolerance == o.Tolerance && this->Stereo == o.Stereo &&
    this->Culls == o.Culls && this->EyeRadius == o.EyeRadius &&
    this->BaselineRadius == o.BaselineRadius;
}

void Pieces::Clear()
{
  this->Vertices.clear();
  this->Sources.clear();
  this->Indices.clear();
  this->Numbers.clear();
  this->Limited = false;
}

void Pieces::AddWhole(unsigned int number)
{
  for (int i = 0; i < 3; i++)
  {
    this->Indices.push_back(static_cast<unsigned int>(this->Vertices.size()));
    PieceVertex vertex;
    vertex.Weights = { i == 0 ? 1.0 : 0.0, i == 1 ? 1.0 : 0.0, i == 2 ? 1.0 : 0.0 };
    this->Vertices.push_back(vertex);
    this->Sources.push_back(number);
  }
  this->Numbers.push_back(number);
}

void Pieces::Append(const Pieces& o)
{
  const auto first = static_cast<unsigned int>(this->Vertices.size());
  this->Corners = o.Corners;
  this->Limited = this->Limited || o.Limited;
  this->Vertices.insert(this->Vertices.end(), o.Vertices.begin(), o.Vertices.end());
  this->Sources.insert(this->Sources.end(), o.Sources.begin(), o.Sources.end());
  this->Numbers.insert(this->Numbers.end(), o.Numbers.begin(), o.Numbers.end());
  this->Indices.reserve(this->Indices.size() + o.Indices.size());
  for (const unsigned int index : o.Indices)
  {
    this->Indices.push_back(first + index);
  }
}

Refiner::Refiner(const RefineView& view)
  : Space(new RefineSpace(view))
{
}

Refiner::~Refiner() = default;

Refiner::Need Refiner::OfCluster(const Box& box, double radius, double edge) const
{
  return this->Space->OfCluster(box, radius, edge);
}

Refiner::Need Refiner::OfCluster(const Affine& toMap, const double b[6], double edge) const
{
  Box box;
  for (int i = 0; i < 8; i++)
  {
    box.Add(toMap.Of(b[i & 1], b[2 + ((i >> 1) & 1)], b[4 + ((i >> 2) & 1)]));
  }
  const double scale = toMap.GetScale();
  const double radius = 0.5 * scale * std::hypot(b[1] - b[0], b[3] - b[2], b[5] - b[4]);
  return this->OfCluster(box, radius, scale * edge);
}

void Refiner::Split(
  const vec3 p[3], const WfvEnd ends[3], unsigned int number, Pieces& pieces) const
{
  const vec3 sides[3] = { p[1] - p[0], p[2] - p[1], p[0] - p[2] };
  const double lengths2[3] = { glm::dot(sides[0], sides[0]), glm::dot(sides[1], sides[1]),
    glm::dot(sides[2], sides[2]) };
  const bool finite = std::isfinite(lengths2[0] + lengths2[1] + lengths2[2] + glm::dot(p[0], p[0]));
  if (finite && lengths2[0] > 0 && lengths2[1] > 0 && lengths2[2] > 0 &&
    !this->Space->IsEdgeOn(p[0], p[1], p[2]))
  {
    thread_local Subdivision subdivision;
    subdivision.Refine(*this->Space, ends, number, pieces);
  }
}

bool Refiner::Take(
  const vec3& a, const vec3& b, const vec3& c, unsigned int number, Pieces& pieces) const
{
  RefineSpace& space = *this->Space;
  const vec3 corners[3] = { a, b, c };
  const WfvEnd ends[3] = { space.wfvEndAt(a), space.wfvEndAt(b), space.wfvEndAt(c) };
  if (space.IsShort(ends[0], ends[1]) && space.IsShort(ends[1], ends[2]) &&
    space.IsShort(ends[2], ends[0]) && space.IsWhole(ends))
  {
    return true;
  }
  this->Split(corners, ends, number, pieces);
  return false;
}

bool Refiner::Take(const vec3 corners[3], const std::uint64_t points[3], unsigned int number,
  EndCache& cache, Pieces& pieces) const
{
  RefineSpace& space = *this->Space;
  WfvEnd ends[3];
  for (int i = 0; i < 3; i++)
  {
    ends[i] = cache.EndOf(space, points[i], corners[i]);
  }
  bool fine = true;
  for (int i = 0; i < 3 && fine; i++)
  {
    const int next = (i + 1) % 3;
    fine = cache.IsShort(space, points[i], points[next], ends[i], ends[next]);
  }
  if (fine && space.IsWhole(ends))
  {
    return true;
  }
  this->Split(corners, ends, number, pieces);
  return false;
}

bool Refiner::Take(const vec3& a, const vec3& b, unsigned int number, Pieces& pieces) const
{
  RefineSpace& space = *this->Space;
  const WfvEnd ends[3] = { space.wfvEndAt(a), space.wfvEndAt(b), space.wfvEndAt(b) };
  if (space.IsShort(ends[0], ends[1]) && space.IsWhole(ends))
  {
    return true;
  }
  pieces.Corners = 2;
  const double length2 = glm::dot(b - a, b - a);
  if (std::isfinite(length2 + glm::dot(a, a)) && length2 > 0)
  {
    thread_local Subdivision subdivision;
    subdivision.RefineSegment(space, ends, number, pieces);
  }
  return false;
}
}
