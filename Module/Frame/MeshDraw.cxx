// SPDX-License-Identifier: BSD-3-Clause
#include "Frame/MeshDraw.h"

#include "Frame/Stages.h"
#include "Frame/vtkWideFoVStage.h"
#include "Refine/Affine.h"
#include "Refine/EndCache.h"

#include "vtkActor.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace wfv
{
namespace
{
// Clusters that a thread takes at least.
constexpr std::size_t LeastClusters = 64;
}

bool MeshDraw::Prepare(vtkPolyData* data, vtkActor* actor, vtkWideFoVStage* stage)
{
  wfv::Stages* const stages = stage->GetStages();
  RefineView view;
  if (!stages || !stages->GetRefineView(stage, actor, view))
  {
    return false;
  }
  double toMap[16];
  stages->GetToMap(actor, toMap);
  const bool still = this->Known && this->Actor == actor && this->Data == data &&
    this->Time == data->GetMTime() && std::equal(toMap, toMap + 16, this->ToMap) &&
    this->View == view;
  if (!still)
  {
    this->Actor = actor;
    this->Data = data;
    this->Time = data->GetMTime();
    this->View = view;
    std::copy_n(toMap, 16, this->ToMap);
    const auto start = std::chrono::steady_clock::now();
    this->Mesh.Update(data);
    const auto made = std::chrono::steady_clock::now();
    this->Refine(data);
    stages->ClusterTime += made - start;
    stages->AddRefineTime(made);
    stages->Counts.ClassifiedMeshes++;
  }
  stages->Counts.Add(this->Counts);
  return this->Known;
}

void MeshDraw::Refine(vtkPolyData* data)
{
  this->Counts = FrameStatistics();
  vtkDataArray* const points = data->GetPoints() ? data->GetPoints()->GetData() : nullptr;
  auto* const singles = vtkFloatArray::SafeDownCast(points);
  auto* const doubles = vtkDoubleArray::SafeDownCast(points);
  this->Known = points != nullptr;
  if (singles)
  {
    this->RefinePoints(singles->GetPointer(0));
  }
  else if (doubles)
  {
    this->RefinePoints(doubles->GetPointer(0));
  }
  else if (points)
  {
    vtkNew<vtkDoubleArray> copy;
    copy->DeepCopy(points);
    this->RefinePoints(copy->GetPointer(0));
  }
}

// One cluster: culled, drawn as it is, or asked triangle by triangle.
template <typename Place>
void MeshDraw::RefineCluster(const Refiner& refiner, const Affine& toMap, const Place& place,
  int cluster, EndCache& cache, Refinement& found) const
{
  const Corners& corners = this->Mesh.GetCorners();
  const vtkIdType first = this->Mesh.GetFirst(cluster);
  const vtkIdType end = this->Mesh.GetEnd(cluster);
  switch (refiner.OfCluster(
    toMap, this->Mesh.GetBounds(cluster).data(), this->Mesh.GetLongestEdge(cluster)))
  {
    case Refiner::Unseen:
      found.CulledClusters++;
      found.Culled += end - first;
      return;
    case Refiner::Nothing:
      found.AddRun(first, end - first);
      return;
    default:
      break;
  }
  std::vector<unsigned int>& singles = found.Singles;
  const std::size_t before = singles.size();
  for (vtkIdType i = first; i < end; i++)
  {
    const std::uint64_t points[3] = { corners[3 * i], corners[3 * i + 1], corners[3 * i + 2] };
    const vec3 p[3] = { place(points[0]), place(points[1]), place(points[2]) };
    const auto number = static_cast<unsigned int>(i);
    if (refiner.Take(p, points, number, cache, found.Refined))
    {
      singles.push_back(number);
    }
  }
  if (static_cast<vtkIdType>(singles.size() - before) == end - first)
  {
    singles.resize(before);
    found.AddRun(first, end - first);
  }
}

template <typename Real>
void MeshDraw::RefinePoints(const Real* points)
{
  const Corners& corners = this->Mesh.GetCorners();
  const Affine toMap(this->ToMap);
  const Refiner refiner(this->View);
  const auto place = [&](std::uint64_t point) {
    const Real* const p = points + 3 * point;
    return toMap.Of(p[0], p[1], p[2]);
  };
  const int clusters = this->Mesh.GetNumberOfClusters();
  const auto parts = static_cast<int>(RefinedDraw::CountParts(clusters, LeastClusters));
  std::vector<Refinement> found(parts);
  vtkSMPTools::For(0, parts, 1, [&](vtkIdType from, vtkIdType to) {
    for (vtkIdType part = from; part < to; part++)
    {
      EndCache cache(corners.size());
      const auto end = static_cast<int>((part + 1) * clusters / parts);
      for (auto c = static_cast<int>(part * clusters / parts); c < end; c++)
      {
        this->RefineCluster(refiner, toMap, place, c, cache, found[part]);
      }
    }
  });
  this->Drawn.Take(found, this->Mesh.GetNumberOfTriangles());
  const Refinement& what = this->Drawn.Get();
  this->Counts.Clusters = clusters;
  this->Counts.CulledClusters = what.CulledClusters;
  this->Counts.Triangles = this->Mesh.GetNumberOfTriangles();
  this->Counts.CulledTriangles = what.Culled;
  this->Counts.ProjectedTriangles = this->View.Limits ? what.CountFine() : 0;
  this->Counts.Pieces = static_cast<vtkIdType>(what.Refined.Numbers.size());
}
}
