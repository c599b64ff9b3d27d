// SPDX-License-Identifier: BSD-3-Clause
// ClusterDraw: classifies a mesh, and lists its triangles by the kinds that they are drawn as.
#include "Frame/ClusterDraw.h"

#include "Clusters/Affine.h"
#include "Frame/Stages.h"
#include "Frame/vtkWideFoVStage.h"
#include "Shaders/Limits.h"

#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <numeric>

namespace
{
// Corners of cells under which a second program costs more than it saves.
constexpr vtkIdType FewCorners = 768;

// Triangles, up to which the program that draws some at edges of several chords draws all that are
// ray-tested. It takes up to five microseconds more for each (llvmpipe, two cores), and another
// program half a second for being made.
constexpr vtkIdType FewByStage = 1280;
}

namespace wfv
{
namespace
{
// Of a code; above them are the chords (common/limits.glsl).
constexpr int KindBits = 2;
static_assert(Classifier::MostChords < 1 << WFV_CHORD_BITS, "so many chords have too few bits");

ClusterDraw::Kind KindOf(DrawClass class_, bool several = false)
{
  switch (class_)
  {
    case DrawClass::Projected:
      return ClusterDraw::Projected;
    case DrawClass::Cut:
      return ClusterDraw::Cut;
    default:
      return several ? ClusterDraw::AtChords : ClusterDraw::ByStage;
  }
}

int KindOf(unsigned int code)
{
  return static_cast<int>(code & ((1u << KindBits) - 1));
}

unsigned int CodeOf(const Classifier::Triangle& triangle)
{
  const int* const n = triangle.Chords;
  int code = KindOf(triangle.Class, std::max({ n[0], n[1], n[2] }) > 1);
  for (int i = 0; i < 3; i++)
  {
    code |= wfvCodeOfChords(i, triangle.Chords[i]) << KindBits;
  }
  return static_cast<unsigned int>(code);
}

// How many times a triangle of this code is drawn.
int PartsOf(unsigned int code)
{
  int most = 1;
  for (int i = 0; KindOf(code) == ClusterDraw::Cut && i < 3; i++)
  {
    most = std::max(most, wfvChordsInCode(i, static_cast<int>(code >> KindBits)));
  }
  return (most + WFV_ROWS_OF_PART - 1) / WFV_ROWS_OF_PART;
}
}

bool ClusterDraw::IsWorthIt(vtkPolyData* data, bool strips)
{
  vtkCellArray* const cells = strips ? data->GetStrips() : data->GetPolys();
  return cells->GetNumberOfConnectivityIds() >= FewCorners;
}

bool ClusterDraw::Prepare(vtkPolyData* data, vtkActor* actor, vtkWideFoVStage* stage)
{
  this->Chosen = All;
  wfv::Stages* const stages = stage->GetStages();
  ClassifierView view;
  if (!IsWorthIt(data, this->ForStrips) || !stages ||
    !stages->GetClassifierView(stage, actor, view))
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
    stages->ClusterTime += std::chrono::steady_clock::now() - start;
    this->Classify(data);
    stages->Counts.ClassifiedMeshes++;
  }
  stages->Counts.Add(this->Found);
  // of a prop that is projected as a whole
  stages->Counts.ProjectedTriangles +=
    stage == stages->Projected ? this->Draws[ByStage].Triangles : 0;
  return this->Known && !this->Draws[ByStage].IsWhole(this->Mesh.GetNumberOfTriangles());
}

void ClusterDraw::Classify(vtkPolyData* data)
{
  this->Found = FrameStatistics();
  vtkDataArray* const points = data->GetPoints() ? data->GetPoints()->GetData() : nullptr;
  auto* const singles = vtkFloatArray::SafeDownCast(points);
  auto* const doubles = vtkDoubleArray::SafeDownCast(points);
  this->Known = singles || doubles;
  if (singles)
  {
    this->ClassifyPoints(singles->GetPointer(0));
  }
  else if (doubles)
  {
    this->ClassifyPoints(doubles->GetPointer(0));
  }
}

template <typename Real>
void ClusterDraw::ClassifyPoints(const Real* points)
{
  const Clusters& mesh = this->Mesh;
  const Corners& corners = mesh.GetCorners();
  const Affine toMap(this->ToMap);
  const double scale = toMap.GetScale();
  const Classifier classifier(this->View);
  this->Classes.resize(mesh.GetNumberOfClusters());
  this->Codes.resize(mesh.GetNumberOfTriangles());
  const auto place = [&](vtkIdType corner) {
    const Real* const p = points + 3 * static_cast<std::size_t>(corners[corner]);
    return toMap.Of(p[0], p[1], p[2]);
  };
  const auto classify = [&](vtkIdType from, vtkIdType to) {
    for (int c = static_cast<int>(from); c < to; c++)
    {
      const std::array<double, 6>& b = mesh.GetBounds(c);
      Box box;
      for (int i = 0; i < 8; i++)
      {
        box.Add(toMap.Of(b[i & 1], b[2 + ((i >> 1) & 1)], b[4 + ((i >> 2) & 1)]));
      }
      const double radius = 0.5 * scale * std::hypot(b[1] - b[0], b[3] - b[2], b[5] - b[4]);
      this->Classes[c] = classifier.OfCluster(box, radius, scale * mesh.GetLongestEdge(c));
      for (vtkIdType i = mesh.GetFirst(c);
           this->Classes[c] == DrawClass::Mixed && i < mesh.GetEnd(c); i++)
      {
        this->Codes[i] =
          CodeOf(classifier.OfTriangle(place(3 * i), place(3 * i + 1), place(3 * i + 2)));
      }
    }
  };
  vtkSMPTools::For(0, mesh.GetNumberOfClusters(), Clusters::Grain, classify);
  this->Gather();
}

void ClusterDraw::KindDraw::Clear()
{
  this->Firsts.clear();
  this->Counts.clear();
  this->Singles.clear();
  this->Triangles = 0;
  this->Loaded = false;
}

void ClusterDraw::KindDraw::Take(KindDraw& other)
{
  for (std::size_t i = 0; i < other.Firsts.size(); i++)
  {
    this->AddRun(other.Firsts[i], other.Counts[i]);
  }
  this->Singles.insert(this->Singles.end(), other.Singles.begin(), other.Singles.end());
  this->Triangles += static_cast<vtkIdType>(other.Singles.size());
  other.Clear();
}

void ClusterDraw::KindDraw::AddRun(vtkIdType first, vtkIdType count)
{
  this->Triangles += count;
  if (!this->Firsts.empty() && this->Firsts.back() + this->Counts.back() == first)
  {
    this->Counts.back() += count;
    return;
  }
  this->Firsts.push_back(first);
  this->Counts.push_back(count);
}

// Triangles of a mixed cluster; those of one class in a row are a draw range where all are of one.
void ClusterDraw::AddMixed(int cluster)
{
  const vtkIdType first = this->Mesh.GetFirst(cluster);
  const vtkIdType end = this->Mesh.GetEnd(cluster);
  const auto codes = this->Codes.begin();
  const int kind = KindOf(codes[first]);
  const auto isRun = [kind](auto code) { return KindOf(code) == kind && PartsOf(code) == 1; };
  if (std::all_of(codes + first, codes + end, isRun))
  {
    this->Draws[kind].AddRun(first, end - first);
    return;
  }
  for (vtkIdType i = first; i < end; i++)
  {
    KindDraw& draw = this->Draws[KindOf(codes[i])];
    draw.Singles.insert(draw.Singles.end(), PartsOf(codes[i]), static_cast<unsigned int>(i));
    draw.Triangles++;
  }
}

// What has been found, in lists.
void ClusterDraw::Gather()
{
  for (KindDraw& draw : this->Draws)
  {
    draw.Clear();
  }
  const int n = this->Mesh.GetNumberOfClusters();
  for (int c = 0; c < n; c++)
  {
    const vtkIdType first = this->Mesh.GetFirst(c);
    const vtkIdType count = this->Mesh.GetEnd(c) - first;
    switch (this->Classes[c])
    {
      case DrawClass::Culled:
        this->Found.CulledClusters++;
        this->Found.CulledTriangles += count;
        break;
      case DrawClass::Mixed:
        this->AddMixed(c);
        break;
      default:
        this->Draws[KindOf(this->Classes[c])].AddRun(first, count);
    }
  }
  if (this->Has(AtChords) && this->Draws[ByStage].Triangles <= FewByStage)
  {
    this->Draws[AtChords].Take(this->Draws[ByStage]);
  }
  this->Found.Clusters = n;
  this->Found.Triangles = this->Mesh.GetNumberOfTriangles();
  this->Found.ProjectedTriangles = this->Draws[Projected].Triangles + this->Draws[Cut].Triangles;
}

std::vector<unsigned int> ClusterDraw::KindDraw::ListAll() const
{
  std::vector<unsigned int> all;
  all.reserve(static_cast<std::size_t>(this->Triangles));
  for (std::size_t i = 0; i < this->Firsts.size(); i++)
  {
    all.resize(all.size() + static_cast<std::size_t>(this->Counts[i]));
    std::iota(all.end() - this->Counts[i], all.end(), static_cast<unsigned int>(this->Firsts[i]));
  }
  all.insert(all.end(), this->Singles.begin(), this->Singles.end());
  return all;
}

std::vector<unsigned int> ClusterDraw::ListChords(const std::vector<unsigned int>& triangles) const
{
  std::vector<unsigned int> chords(triangles.size());
  int part = 0;
  for (std::size_t i = 0; i < triangles.size(); i++)
  {
    part = i > 0 && triangles[i] == triangles[i - 1] ? part + 1 : 0;
    chords[i] =
      (this->Codes[triangles[i]] >> KindBits) | static_cast<unsigned int>(wfvCodeOfPart(part));
  }
  return chords;
}
}
