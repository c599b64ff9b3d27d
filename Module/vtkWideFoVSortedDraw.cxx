// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWideFoVSortedDraw.h"

#include "Compat/vtkWideFoVStockEdits.h"

#include "WideFoVGlsl.h"
#include "vtkWideFoVGl.h"
#include "vtkWideFoVShaderBuilder.h"
#include "vtkWideFoVShaderText.h"
#include "vtkWideFoVSortedEntry.h"
#include "vtkWideFoVStages.h"

#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLBufferObject.h"
#include "vtkOpenGLIndexBufferObject.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLVertexBufferObject.h"
#include "vtkOpenGLVertexBufferObjectGroup.h"
#include "vtkPolyData.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace
{
// Corners of cells under which sorting is not worth a draw more.
constexpr vtkIdType FewCorners = 768;

// By how much a row-major matrix stretches at the most, and no more than twice that.
double LongestAxis(const double m[16])
{
  double sum = 0;
  for (int i = 0; i < 3; i++)
  {
    sum += m[i] * m[i] + m[4 + i] * m[4 + i] + m[8 + i] * m[8 + i];
  }
  return std::sqrt(sum);
}

// Frames of one view that are drawn in haste: to sort triangles one by one takes as long as it
// saves in some ten frames.
constexpr int HastyFrames = 10;

// Triangles from which on a mesh that is sorted well, for a view that stands, keeps no more than
// what draws it: what is found anew for the next such view, the neighbours, takes some hundredths
// of its time.
constexpr std::size_t LargeMesh = 1000000;

// Actors that may share a mapper and each keep what was sorted for them.
constexpr std::size_t MostEntries = 16;
}

namespace wfv
{
bool SortedDraw::IsWorthIt(vtkPolyData* data, bool strips)
{
  vtkCellArray* const cells = strips ? data->GetStrips() : data->GetPolys();
  return cells->GetNumberOfConnectivityIds() >= FewCorners;
}

SortedDraw::SortedDraw(bool strips)
  : ForStrips(strips)
  , Mesh(strips)
{
  for (vtkOpenGLHelper& helper : this->Helpers)
  {
    helper.PrimitiveType =
      strips ? vtkOpenGLPolyDataMapper::PrimitiveTriStrips : vtkOpenGLPolyDataMapper::PrimitiveTris;
  }
}

SortedDraw::~SortedDraw() = default;

// What is kept for an actor; nullptr where it is one too many.
SortedDraw::Entry* SortedDraw::Find(vtkActor* actor)
{
  std::unique_ptr<Entry>& entry = this->Entries[actor];
  if (!entry || entry->Actor != actor)
  {
    if (this->Entries.size() > MostEntries)
    {
      this->Entries.erase(actor);
      return nullptr;
    }
    entry.reset(new Entry);
    entry->Actor = actor;
  }
  return entry.get();
}

bool SortedDraw::Prepare(
  vtkPolyData* data, vtkActor* actor, vtkWideFoVStage* stage, double rounding)
{
  this->Current = nullptr;
  this->Chosen = SortedDraw::All;
  if (!IsWorthIt(data, this->ForStrips))
  {
    return false;
  }
  vtkWideFoVStages* const stages = stage->GetStages();
  SortView view;
  if (!stages || !stages->GetSortView(stage, actor, view))
  {
    return false;
  }
  this->Eye = stages->GetEye(stage);
  this->Both = stages->IsOfBoth(stage);
  Entry* const found = this->Find(actor);
  return found && this->PrepareEntry(*found, data, view, stages, rounding);
}

// view: rounding is still to be added.
bool SortedDraw::PrepareEntry(
  Entry& e, vtkPolyData* data, SortView& view, vtkWideFoVStages* stages, double rounding)
{
  double toMap[16];
  stages->GetToMap(e.Actor, toMap);
  view.Rounding = rounding * LongestAxis(toMap);
  const bool still = e.Data == data && e.Time == data->GetMTime() &&
    std::equal(toMap, toMap + 16, e.ToMap) && e.View == view;
  e.CountFrame(still, this->Eye);
  const bool haste = !stages->SortsWhileMoving() && e.Frames < HastyFrames;
  if (!still || (e.Haste && !haste))
  {
    e.Haste = haste;
    e.View = view;
    std::copy_n(toMap, 16, e.ToMap);
    this->Sort(e, data);
    stages->Counts.SortedMeshes += haste ? 0 : 1;
    stages->Hidden.Change();
  }
  this->Hide(e, data, stages);
  this->Current = &e;
  e.Found.HiddenTriangles = e.Skips ? static_cast<vtkIdType>(e.GetNumberOfHidden(this->Eye)) : 0;
  e.Found.UnseenTriangles = e.All > 0 ? e.LeftOut[this->Eye + 1] + e.Found.HiddenTriangles : 0;
  stages->Counts.Add(e.Found);
  return e.All > 0 && e.Lots[Covered].All != e.All;
}

void SortedDraw::Sort(Entry& e, vtkPolyData* data)
{
  this->Mesh.Update(data);
  e.Data = data;
  e.Time = data->GetMTime();
  e.Found = FrameCounts();
  e.Found.Clusters = this->Mesh.GetNumberOfClusters();
  e.Found.Triangles = this->Mesh.GetNumberOfTriangles();
  e.All = static_cast<std::size_t>(e.Found.Triangles);
  SortView still = e.View;
  still.Moving = 0;
  const bool sorted = e.Haste
    ? this->Triangles.SortInHaste(this->Mesh, data->GetPoints(), e.ToMap, e.View)
    : this->Triangles.Sort(this->Mesh, data->GetPoints(), e.ToMap, still);
  if (!sorted)
  {
    e.All = 0;
    return;
  }
  this->Take(e);
  if (!e.Haste && e.All >= LargeMesh)
  {
    this->Mesh.LetGo();
    this->Triangles = Sorter();
    e.Order.shrink_to_fit(); // it may have been a larger one
  }
}

void SortedDraw::Take(Entry& e)
{
  e.Found.UnseenClusters = this->Triangles.GetNumberOfUnseen();
  for (const int eye : { -1, 0, 1 })
  {
    e.LeftOut[eye + 1] = this->Triangles.GetNumberOfLeftOut(eye);
  }
  this->Triangles.TakeOrder(e.Order);
  this->Triangles.TakeFolds(e.Folds);
  e.Lots[Covered] = this->Triangles.GetCovered();
  e.Lots[Calm] = this->Triangles.GetCalm();
  e.Lots[Plain] = this->Triangles.GetPlain();
  e.Reaches = this->Triangles.GetReaches();
  e.Loaded = e.FoldsLoaded = false;
  e.HiddenIn = 0;
  e.TakePieces(this->Triangles.GetPieces());
  this->NumbersOf = this->NumbersOf == &e ? nullptr : this->NumbersOf;
  if (e.IsWhole())
  {
    e.Order.clear();
  }
  else
  {
    this->Upload(e);
  }
}

// Corners of the triangles in their order.
void SortedDraw::Upload(Entry& e)
{
  const Corners& corners = this->Mesh.GetCorners();
  std::vector<unsigned int> indices;
  indices.reserve(3 * e.Order.size());
  for (const unsigned int triangle : e.Order)
  {
    const std::size_t first = 3 * static_cast<std::size_t>(triangle);
    indices.insert(indices.end(), { corners[first], corners[first + 1], corners[first + 2] });
  }
  if (!indices.empty())
  {
    e.Indices->Upload(indices, vtkOpenGLBufferObject::ElementArrayBuffer);
  }
}

std::size_t SortedDraw::GetNumberOf(Lot lot) const
{
  return this->Current ? this->Current->GetRun(lot, this->Eye).second : 0;
}

void SortedDraw::Draw(vtkOpenGLIndexBufferObject* all, const DrawnPart& part)
{
  const bool own = this->Chosen != SortedDraw::All && !this->Current->IsWhole();
  vtkOpenGLIndexBufferObject* const indices = own ? this->Current->Indices.Get() : all;
  const auto run = this->Chosen == SortedDraw::All
    ? std::pair<std::size_t, std::size_t>(0, part.Indices / 3)
    : this->Current->GetRun(this->Chosen, this->Eye);
  const std::size_t first = own ? 3 * run.first : part.FirstIndex;
  const std::size_t count = 3 * run.second;
  // the mapper's own indices count from its first vertex, the sorted ones from the mesh's
  const unsigned int from = own ? 0 : part.FirstVertex;
  indices->Bind();
  const auto base = static_cast<GLint>(own ? part.FirstVertex : 0);
  const auto* const start = reinterpret_cast<void*>(first * sizeof(GLuint));
  if (this->Both && this->Chosen == Plain)
  {
    glDrawElementsInstancedBaseVertex(
      GL_TRIANGLES, static_cast<GLsizei>(count), GL_UNSIGNED_INT, start, 2, base);
  }
  else
  {
    glDrawRangeElementsBaseVertex(GL_TRIANGLES, from, from + part.Vertices - 1,
      static_cast<GLsizei>(count), GL_UNSIGNED_INT, const_cast<void*>(start), base);
  }
  indices->Release();
}

void SortedDraw::LoadNumbers(vtkOpenGLRenderWindow* window)
{
  static const std::vector<unsigned int> none(1, 0);
  Entry* const wanted =
    this->Chosen == SortedDraw::All || this->Current->IsWhole() ? nullptr : this->Current;
  if (this->Numbers.IsLoadedFor(window) && (!wanted || this->NumbersOf == wanted))
  {
    return;
  }
  this->NumbersOf = wanted;
  this->Numbers.Load(window, wanted ? wanted->Order : none);
}

void SortedDraw::SetFolds(vtkShaderProgram* program, vtkOpenGLRenderWindow* window)
{
  this->Bound = true;
  const bool known = this->Chosen != SortedDraw::All && !this->Current->Folds.empty();
  if (known)
  {
    this->Current->LoadFolds(window);
  }
  else if (!this->Numbers.IsLoadedFor(window))
  {
    this->LoadNumbers(window); // a texture there has to be
  }
  BufferTexture& folds = known ? this->Current->FoldTexture : this->Numbers;
  folds.Activate(program, "wfvKnownFolds");
  program->SetUniformi("wfvFirstFold",
    known ? static_cast<int>(this->Current->GetRun(this->Chosen, this->Eye).first) : -1);
}

void SortedDraw::SetParameters(vtkShaderProgram* program, vtkWindow* window)
{
  auto* const context = static_cast<vtkOpenGLRenderWindow*>(window);
  if (this->Chosen == Calm && program->IsUniformUsed("wfvReaches"))
  {
    this->Bound = true;
    this->Current->Load(context);
    this->Current->ReachTexture.Activate(program, "wfvReaches");
    this->Current->PieceTexture.Activate(program, "wfvPieces");
    const std::size_t from =
      this->Current->GetRun(Calm, this->Eye).first - this->Current->GetFirst(Calm);
    program->SetUniformi("wfvFirstReach", static_cast<int>(from));
  }
  if (program->IsUniformUsed("wfvKnownFolds"))
  {
    this->SetFolds(program, context);
  }
  if (!program->IsUniformUsed("wfvNumbers"))
  {
    return;
  }
  this->Bound = true;
  this->LoadNumbers(context);
  this->Numbers.Activate(program, "wfvNumbers");
  const bool own = this->Chosen == SortedDraw::All || this->Current->IsWhole();
  const std::size_t first = own ? 0 : this->Current->GetRun(this->Chosen, this->Eye).first;
  program->SetUniformi("wfvFirstNumber", own ? -1 : static_cast<int>(first));
}

void SortedDraw::Finish()
{
  this->Chosen = SortedDraw::All;
  if (!this->Bound)
  {
    return; // of many small props each would be asked
  }
  this->Bound = false;
  this->Numbers.Deactivate();
  if (this->Current)
  {
    this->Current->ReachTexture.Deactivate();
    this->Current->PieceTexture.Deactivate();
    this->Current->FoldTexture.Deactivate();
  }
}

void SortedDraw::ReleaseGraphicsResources(vtkWindow* window)
{
  for (auto& entry : this->Entries)
  {
    entry.second->Indices->ReleaseGraphicsResources();
    entry.second->ReachTexture.ReleaseGraphicsResources(window);
    entry.second->PieceTexture.ReleaseGraphicsResources(window);
    entry.second->FoldTexture.ReleaseGraphicsResources(window);
  }
  this->Entries.clear();
  this->Current = this->NumbersOf = nullptr;
  for (vtkOpenGLHelper& helper : this->Helpers)
  {
    helper.ReleaseGraphicsResources(window);
  }
  this->Numbers.ReleaseGraphicsResources(window);
}

// Points that are float32 stay as they are, others are rounded, and both where VTK shifts and
// scales them.
double RoundingOf(
  vtkOpenGLVertexBufferObjectGroup* buffers, vtkPoints* points, const double bounds[6])
{
  constexpr double Rounded = 1.0 / (1 << 21); // of the largest coordinate: four roundings
  vtkOpenGLVertexBufferObject* const buffer = buffers->GetVBO("vertexMC");
  if (!buffer || !points ||
    (points->GetDataType() == VTK_FLOAT && !buffer->GetCoordShiftAndScaleEnabled()))
  {
    return 0;
  }
  double largest = 0;
  for (int i = 0; i < 6; i++)
  {
    largest = std::max(largest, std::abs(bounds[i]));
  }
  return Rounded * largest;
}

void TakeSortedNumbers(std::string& fragment)
{
  if (stock::Replace(fragment, stock::Edit::PrimitiveNumber, "wfvNumber()", stock::Found::May) >= 0)
  {
    vtkWideFoVShaderBuilder::Declare(fragment, sorted_number_glsl);
  }
}
}
