// SPDX-License-Identifier: BSD-3-Clause
#include "Frame/RefinedDraw.h"

#include "Compat/Gl.h"
#include "Compat/Reports.h"
#include "Compat/StockEdits.h"
#include "Shaders/ShaderBuilder.h"
#include "WideFoVGlsl.h"

#include "vtkObject.h"
#include "vtkOpenGLHelper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"

#include <cstdint>
#include <numeric>

namespace wfv
{
void Refinement::AddRun(vtkIdType first, vtkIdType count)
{
  if (!this->Firsts.empty() && this->Firsts.back() + this->Counts.back() == first)
  {
    this->Counts.back() += count;
    return;
  }
  this->Firsts.push_back(first);
  this->Counts.push_back(count);
}

void Refinement::Append(const Refinement& other)
{
  for (std::size_t i = 0; i < other.Firsts.size(); i++)
  {
    this->AddRun(other.Firsts[i], other.Counts[i]);
  }
  this->Singles.insert(this->Singles.end(), other.Singles.begin(), other.Singles.end());
  this->Refined.Append(other.Refined);
  this->Culled += other.Culled;
  this->CulledClusters += other.CulledClusters;
}

vtkIdType Refinement::CountFine() const
{
  return std::accumulate(
    this->Counts.begin(), this->Counts.end(), static_cast<vtkIdType>(this->Singles.size()));
}

std::vector<unsigned int> Refinement::ListFine() const
{
  std::vector<unsigned int> all;
  all.reserve(static_cast<std::size_t>(this->CountFine()));
  for (std::size_t i = 0; i < this->Firsts.size(); i++)
  {
    all.resize(all.size() + static_cast<std::size_t>(this->Counts[i]));
    std::iota(all.end() - this->Counts[i], all.end(), static_cast<unsigned int>(this->Firsts[i]));
  }
  all.insert(all.end(), this->Singles.begin(), this->Singles.end());
  return all;
}

void RefinedDraw::Take(const std::vector<Refinement>& parts, vtkIdType total)
{
  this->What = Refinement();
  this->Total = total;
  for (const Refinement& part : parts)
  {
    this->What.Append(part);
  }
  if (this->What.Refined.Limited && IsNews("pieces of a triangle"))
  {
    vtkGenericWarningMacro(
      "A triangle that passes the eye would need more than a million pieces: it "
      "is drawn coarser than the tolerance.");
  }
  this->Loaded = false;
  this->FineNumbers.Forget();
  this->PieceNumbers.Forget();
  this->Buffers.Forget();
}

unsigned int RefinedDraw::Mode() const
{
  return this->NumberOfCorners == 3 ? GL_TRIANGLES : GL_LINES;
}

void RefinedDraw::LoadFine(const Corners& corners, bool numbered)
{
  if (this->Loaded && this->Numbered == numbered)
  {
    return;
  }
  this->Loaded = true;
  this->Numbered = numbered;
  const std::vector<unsigned int> all =
    numbered ? this->What.ListFine() : std::vector<unsigned int>();
  const std::vector<unsigned int>& primitives = numbered ? all : this->What.Singles;
  const auto n = static_cast<std::size_t>(this->NumberOfCorners);
  std::vector<unsigned int> indices(n * primitives.size());
  for (std::size_t i = 0; i < primitives.size(); i++)
  {
    for (std::size_t k = 0; k < n; k++)
    {
      indices[n * i + k] = corners[n * primitives[i] + k];
    }
  }
  this->InBuffer = primitives.size();
  if (!indices.empty())
  {
    this->Indices->Upload(indices, vtkOpenGLBufferObject::ElementArrayBuffer);
  }
}

void RefinedDraw::SetOwnNumbers(vtkShaderProgram* program, vtkOpenGLRenderWindow* window)
{
  if (program->IsUniformUsed("wfvNumbers"))
  {
    if (!this->Nothing.IsLoadedFor(window))
    {
      this->Nothing.Load(window, std::vector<unsigned int>(1, 0));
    }
    this->Nothing.Activate(program, "wfvNumbers");
    program->SetUniformi("wfvFirstNumber", -1);
  }
}

void RefinedDraw::Finish()
{
  this->Nothing.Deactivate();
}

// All primitives, in the mapper's own order.
void RefinedDraw::DrawOwn(const DrawnPart& part, vtkOpenGLRenderWindow* window)
{
  this->SetOwnNumbers(part.Helper->Program, window);
  part.Helper->IBO->Bind();
  glDrawRangeElements(this->Mode(), part.FirstVertex, part.FirstVertex + part.Vertices - 1,
    static_cast<GLsizei>(part.Indices), GL_UNSIGNED_INT,
    reinterpret_cast<void*>(static_cast<std::uintptr_t>(part.FirstIndex * sizeof(GLuint))));
  part.Helper->IBO->Release();
  this->Finish();
}

void RefinedDraw::DrawRanges(const DrawnPart& part)
{
  const auto n = static_cast<std::size_t>(this->NumberOfCorners);
  this->RunLengths.clear();
  this->RunStarts.clear();
  for (std::size_t i = 0; i < this->What.Counts.size(); i++)
  {
    const std::size_t first = part.FirstIndex + n * static_cast<std::size_t>(this->What.Firsts[i]);
    this->RunLengths.push_back(static_cast<GLsizei>(this->NumberOfCorners * this->What.Counts[i]));
    this->RunStarts.push_back(
      reinterpret_cast<const void*>(static_cast<std::uintptr_t>(first * sizeof(GLuint))));
  }
  part.Helper->IBO->Bind();
  glMultiDrawElements(this->Mode(), this->RunLengths.data(), GL_UNSIGNED_INT,
    this->RunStarts.data(), static_cast<GLsizei>(this->RunLengths.size()));
  part.Helper->IBO->Release();
}

void RefinedDraw::DrawFine(
  const DrawnPart& part, const Corners& corners, vtkOpenGLRenderWindow* window)
{
  const bool asked = part.Helper->Program->IsUniformUsed("wfvNumbers");
  // should the mapper have other primitives than the mesh, its indices do not serve
  const bool same = part.Indices == static_cast<std::size_t>(this->NumberOfCorners * this->Total);
  const bool numbered = asked || !same;
  this->LoadFine(corners, numbered);
  this->FineNumbers.Activate(
    part.Helper->Program, window, [this] { return this->What.ListFine(); });
  if (!numbered && !this->What.Counts.empty())
  {
    this->DrawRanges(part);
  }
  if (this->InBuffer > 0)
  {
    // the mapper's own indices count from its first vertex, these from the first of the part
    this->Indices->Bind();
    glDrawElementsBaseVertex(this->Mode(),
      static_cast<GLsizei>(static_cast<std::size_t>(this->NumberOfCorners) * this->InBuffer),
      GL_UNSIGNED_INT, nullptr, static_cast<GLint>(part.FirstVertex));
    this->Indices->Release();
  }
  this->FineNumbers.Deactivate();
}

void RefinedDraw::DrawPieces(
  const DrawnPart& part, const Corners& corners, vtkOpenGLRenderWindow* window)
{
  vtkShaderProgram* const program = part.Helper->Program;
  if (!this->Buffers.Load(this->What.Refined, corners, part.Buffers, part.FirstVertex))
  {
    return;
  }
  if (PieceBuffers::AsksForNumbers(program))
  {
    this->Buffers.LoadNumbers(this->What.Refined, corners, part.FirstVertex);
  }
  this->PieceNumbers.Activate(program, window, [this] { return this->What.Refined.Numbers; });
  this->Buffers.Draw(program, this->Mode());
  this->PieceNumbers.Deactivate();
  part.Helper->VAO->Bind();
}

void RefinedDraw::Draw(const DrawnPart& part, const Corners& corners, vtkOpenGLRenderWindow* window)
{
  if (!part.Helper->Program)
  {
    return;
  }
  const vtkIdType fine = this->What.CountFine();
  if (fine == this->Total)
  {
    this->DrawOwn(part, window);
    return;
  }
  if (fine > 0)
  {
    this->DrawFine(part, corners, window);
  }
  if (!this->What.Refined.Numbers.empty())
  {
    this->DrawPieces(part, corners, window);
  }
}

void RefinedDraw::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Indices->ReleaseGraphicsResources();
  this->FineNumbers.ReleaseGraphicsResources(window);
  this->PieceNumbers.ReleaseGraphicsResources(window);
  this->Buffers.ReleaseGraphicsResources();
  this->Nothing.ReleaseGraphicsResources(window);
  this->Loaded = false;
}

void TakeNumbers(std::string& vertex, std::string& fragment)
{
  if (stock::Replace(fragment, stock::Edit::PrimitiveNumber, "wfvNumber()", stock::Found::May) >= 0)
  {
    wfv::ShaderBuilder::Declare(fragment, triangle_number_glsl);
  }
  if (stock::Replace(vertex, stock::Edit::VertexNumber, "wfvVertexNumber()", stock::Found::May) >=
    0)
  {
    wfv::ShaderBuilder::Declare(vertex, vertex_number_glsl);
  }
}
}
