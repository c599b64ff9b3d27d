// SPDX-License-Identifier: BSD-3-Clause
#include "Clusters/ClusterDraw.h"

#include "Compat/vtkWideFoVStockEdits.h"

#include "WideFoVGlsl.h"
#include "vtkWideFoVGl.h"
#include "vtkWideFoVShaderBuilder.h"
#include "vtkWideFoVShaderText.h"
#include "vtkWideFoVStages.h"

#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkOpenGLBufferObject.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

namespace
{
// Corners of cells under which a second program costs more than it saves.
constexpr vtkIdType FewCorners = 768;

// Clusters a thread takes at least.
constexpr vtkIdType Grain = 64;

// A row-major affine matrix.
struct Affine
{
  wfv::vec3 Columns[3];
  wfv::vec3 Shift;

  explicit Affine(const double m[16])
    : Columns{ wfv::vec3(m[0], m[4], m[8]), wfv::vec3(m[1], m[5], m[9]),
      wfv::vec3(m[2], m[6], m[10]) }
    , Shift(m[3], m[7], m[11])
  {
  }

  wfv::vec3 Of(double x, double y, double z) const
  {
    return this->Columns[0] * x + this->Columns[1] * y + this->Columns[2] * z + this->Shift;
  }

  // By how much it stretches at the most: exact where all axes are scaled alike.
  double GetScale() const
  {
    double most = 0;
    for (const wfv::vec3& a : this->Columns)
    {
      double sum = 0;
      for (const wfv::vec3& b : this->Columns)
      {
        sum += std::abs(glm::dot(a, b));
      }
      most = std::max(most, sum);
    }
    return std::sqrt(most);
  }
};
}

namespace wfv
{
namespace
{
// Of a code.
constexpr int KindBits = 3;
constexpr int EdgeBits = 5;

ClusterDraw::Kind KindOf(DrawClass class_)
{
  switch (class_)
  {
    case DrawClass::Projected:
      return ClusterDraw::Projected;
    case DrawClass::Strip:
      return ClusterDraw::Strip;
    case DrawClass::Grid:
      return ClusterDraw::Grid;
    case DrawClass::LongStrip:
      return ClusterDraw::LongStrip;
    default:
      return ClusterDraw::ByStage;
  }
}

int KindOf(unsigned int code)
{
  return static_cast<int>(code & ((1u << KindBits) - 1));
}

unsigned int CodeOf(const Classifier::Triangle& triangle)
{
  int code = KindOf(triangle.Class);
  for (int i = 0; i < 3; i++)
  {
    code |= triangle.Chords[i] << (KindBits + EdgeBits * i);
  }
  return static_cast<unsigned int>(code);
}
}

vtkWideFoVStage* ClusterDraw::GetStage(Kind kind, vtkWideFoVStage* stage)
{
  vtkWideFoVStages* const stages = stage->GetStages();
  switch (kind)
  {
    case Projected:
      return stages->Plain;
    case Strip:
      return stages->Strip;
    case Grid:
      return stages->Grid;
    case LongStrip:
      return stages->LongStrip;
    default:
      return stage;
  }
}

bool ClusterDraw::IsWorthIt(vtkPolyData* data, bool strips)
{
  vtkCellArray* const cells = strips ? data->GetStrips() : data->GetPolys();
  return cells->GetNumberOfConnectivityIds() >= FewCorners;
}

ClusterDraw::ClusterDraw(bool strips)
  : ForStrips(strips)
  , Mesh(strips)
{
  for (vtkOpenGLHelper& helper : this->Helpers)
  {
    helper.PrimitiveType =
      strips ? vtkOpenGLPolyDataMapper::PrimitiveTriStrips : vtkOpenGLPolyDataMapper::PrimitiveTris;
  }
}

bool ClusterDraw::Prepare(vtkPolyData* data, vtkActor* actor, vtkWideFoVStage* stage)
{
  this->Chosen = All;
  vtkWideFoVStages* const stages = stage->GetStages();
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
    this->Classify(data);
    stages->Counts.ClassifiedMeshes++;
    const bool projects = stage == stages->Plain;
    this->Found.ProjectedTriangles += projects ? this->Draws[ByStage].Triangles : 0;
  }
  stages->Counts.Add(this->Found);
  return this->Known && !this->Draws[ByStage].IsWhole(this->Mesh.GetNumberOfTriangles());
}

void ClusterDraw::Classify(vtkPolyData* data)
{
  this->Mesh.Update(data);
  this->Found = FrameCounts();
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
  vtkSMPTools::For(0, mesh.GetNumberOfClusters(), Grain, classify);
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

// Triangles of a mixed cluster; runs of one class are drawn as runs where all are of one.
void ClusterDraw::AddMixed(int cluster)
{
  const vtkIdType first = this->Mesh.GetFirst(cluster);
  const vtkIdType end = this->Mesh.GetEnd(cluster);
  const auto codes = this->Codes.begin();
  const int kind = KindOf(codes[first]);
  if (std::all_of(codes + first, codes + end, [kind](auto code) { return KindOf(code) == kind; }))
  {
    this->Draws[kind].AddRun(first, end - first);
    return;
  }
  for (vtkIdType i = first; i < end; i++)
  {
    KindDraw& draw = this->Draws[KindOf(codes[i])];
    draw.Singles.push_back(static_cast<unsigned int>(i));
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
        this->Found.UnseenClusters++;
        this->Found.UnseenTriangles += count;
        break;
      case DrawClass::Mixed:
        this->AddMixed(c);
        break;
      default:
        this->Draws[KindOf(this->Classes[c])].AddRun(first, count);
    }
  }
  this->Found.Clusters = n;
  this->Found.Triangles = this->Mesh.GetNumberOfTriangles();
  this->Found.ProjectedTriangles = this->Draws[Projected].Triangles + this->Draws[Strip].Triangles +
    this->Draws[Grid].Triangles + this->Draws[LongStrip].Triangles;
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

void ClusterDraw::Load(KindDraw& draw, bool numbered)
{
  if (draw.Loaded && draw.Numbered == numbered)
  {
    return;
  }
  draw.Loaded = true;
  draw.Numbered = numbered;
  const std::vector<unsigned int> all = numbered ? draw.ListAll() : std::vector<unsigned int>();
  const std::vector<unsigned int>& triangles = numbered ? all : draw.Singles;
  const Corners& corners = this->Mesh.GetCorners();
  std::vector<unsigned int> indices(3 * triangles.size());
  for (std::size_t i = 0; i < triangles.size(); i++)
  {
    const std::size_t first = 3 * static_cast<std::size_t>(triangles[i]);
    indices[3 * i] = corners[first];
    indices[3 * i + 1] = corners[first + 1];
    indices[3 * i + 2] = corners[first + 2];
  }
  draw.InBuffer = triangles.size();
  if (!indices.empty())
  {
    draw.Indices->Upload(indices, vtkOpenGLBufferObject::ElementArrayBuffer);
  }
}

bool ClusterDraw::IsOwn() const
{
  return this->Chosen == All ||
    this->Draws[this->Chosen].IsWhole(this->Mesh.GetNumberOfTriangles());
}

void ClusterDraw::DrawRuns(const KindDraw& draw, std::size_t firstIndex)
{
  std::vector<GLsizei>& lengths = this->RunLengths;
  std::vector<const void*>& starts = this->RunStarts;
  lengths.resize(draw.Counts.size());
  starts.resize(draw.Counts.size());
  for (std::size_t i = 0; i < lengths.size(); i++)
  {
    const std::size_t first = firstIndex + 3 * static_cast<std::size_t>(draw.Firsts[i]);
    lengths[i] = static_cast<GLsizei>(3 * draw.Counts[i]);
    starts[i] = reinterpret_cast<const void*>(static_cast<std::uintptr_t>(first * sizeof(GLuint)));
  }
  glMultiDrawElements(GL_TRIANGLES, lengths.data(), GL_UNSIGNED_INT, starts.data(),
    static_cast<GLsizei>(lengths.size()));
}

void ClusterDraw::Draw(vtkOpenGLIndexBufferObject* all, const DrawnPart& part)
{
  if (this->IsOwn())
  {
    all->Bind();
    glDrawRangeElements(GL_TRIANGLES, part.FirstVertex, part.FirstVertex + part.Vertices - 1,
      static_cast<GLsizei>(part.Indices), GL_UNSIGNED_INT,
      reinterpret_cast<void*>(static_cast<std::uintptr_t>(part.FirstIndex * sizeof(GLuint))));
    all->Release();
    return;
  }
  KindDraw& draw = this->Draws[this->Chosen];
  // should the mapper have other triangles than the mesh, its indices do not serve
  const bool same = part.Indices == 3 * static_cast<std::size_t>(this->Found.Triangles);
  const bool numbered = this->Numbered || !same;
  this->Load(draw, numbered);
  if (!numbered && !draw.Counts.empty())
  {
    all->Bind();
    this->DrawRuns(draw, part.FirstIndex);
    all->Release();
  }
  if (draw.InBuffer > 0)
  {
    // the mapper's own indices count from its first vertex, these from the mesh's
    draw.Indices->Bind();
    glDrawElementsBaseVertex(GL_TRIANGLES, static_cast<GLsizei>(3 * draw.InBuffer), GL_UNSIGNED_INT,
      nullptr, static_cast<GLint>(part.FirstVertex));
    draw.Indices->Release();
  }
}

// What programs ask for of the triangles of a kind, in the order that they are drawn in.
void ClusterDraw::LoadLists(KindDraw& draw, vtkOpenGLRenderWindow* window)
{
  if (draw.Numbers.IsLoadedFor(window) && draw.Loaded && draw.Numbered)
  {
    return;
  }
  this->Load(draw, true);
  const std::vector<unsigned int> triangles = draw.ListAll();
  std::vector<unsigned int> codes(triangles.size());
  std::transform(triangles.begin(), triangles.end(), codes.begin(),
    [this](unsigned int triangle) { return this->Codes[triangle] >> KindBits; });
  draw.Numbers.Load(window, triangles);
  draw.Chords.Load(window, codes);
}

void ClusterDraw::SetParameters(vtkShaderProgram* program, vtkWindow* window)
{
  const bool numbers = program->IsUniformUsed("wfvNumbers");
  const bool chords = program->IsUniformUsed("wfvChords");
  this->Numbered = numbers || chords;
  if (!this->Numbered)
  {
    return;
  }
  this->Bound = true;
  auto* const context = static_cast<vtkOpenGLRenderWindow*>(window);
  const bool own = this->IsOwn();
  if (!own)
  {
    this->LoadLists(this->Draws[this->Chosen], context);
  }
  else if (!this->Nothing.IsLoadedFor(context))
  {
    this->Nothing.Load(context, std::vector<unsigned int>(1, 0));
  }
  if (numbers)
  {
    (own ? this->Nothing : this->Draws[this->Chosen].Numbers).Activate(program, "wfvNumbers");
    program->SetUniformi("wfvFirstNumber", own ? -1 : 0);
  }
  if (chords)
  {
    (own ? this->Nothing : this->Draws[this->Chosen].Chords).Activate(program, "wfvChords");
    program->SetUniformi("wfvHasChords", !own && this->View.Limits);
  }
}

void ClusterDraw::Finish()
{
  this->Chosen = All;
  if (!this->Bound)
  {
    return; // of many small props each would be asked
  }
  this->Bound = false;
  this->Nothing.Deactivate();
  for (KindDraw& draw : this->Draws)
  {
    draw.Numbers.Deactivate();
    draw.Chords.Deactivate();
  }
}

void ClusterDraw::ReleaseGraphicsResources(vtkWindow* window)
{
  for (KindDraw& draw : this->Draws)
  {
    draw.Indices->ReleaseGraphicsResources();
    draw.Numbers.ReleaseGraphicsResources(window);
    draw.Chords.ReleaseGraphicsResources(window);
    draw.Loaded = false;
  }
  for (vtkOpenGLHelper& helper : this->Helpers)
  {
    helper.ReleaseGraphicsResources(window);
  }
  this->Nothing.ReleaseGraphicsResources(window);
}

void TakeTriangleNumbers(std::string& fragment)
{
  if (stock::Replace(fragment, stock::Edit::PrimitiveNumber, "wfvNumber()", stock::Found::May) >= 0)
  {
    vtkWideFoVShaderBuilder::Declare(fragment, sorted_number_glsl);
  }
}
}
