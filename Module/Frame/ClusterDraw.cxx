// SPDX-License-Identifier: BSD-3-Clause
// ClusterDraw: draws what ClusterLists.cxx has listed.
#include "Frame/ClusterDraw.h"

#include "Compat/Gl.h"
#include "Compat/StockEdits.h"
#include "Frame/Stages.h"
#include "Shaders/ShaderBuilder.h"
#include "WideFoVGlsl.h"

#include "vtkOpenGLBufferObject.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"

#include <cstddef>
#include <cstdint>

namespace wfv
{
vtkWideFoVStage* ClusterDraw::GetStage(Kind kind, vtkWideFoVStage* stage)
{
  wfv::Stages* const stages = stage->GetStages();
  switch (kind)
  {
    case Projected:
      return stages->Projected;
    case Cut:
      return stages->Cut;
    case AtChords:
      return stages->PreClipAtChords;
    default:
      return stage;
  }
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
    (this->Chosen != Cut && // which has chords
      this->Draws[this->Chosen].IsWhole(this->Mesh.GetNumberOfTriangles()));
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
  draw.Numbers.Load(window, triangles);
  draw.Chords.Load(window, this->ListChords(triangles));
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
    wfv::ShaderBuilder::Declare(fragment, triangle_number_glsl);
  }
}
}
