// SPDX-License-Identifier: BSD-3-Clause
#include "Frame/vtkWideFoVCompositeHelper.h"

#include "Frame/LineDraw.h"
#include "Frame/MeshDraw.h"
#include "Frame/Stages.h"

#include "vtkActor.h"
#include "vtkHardwareSelector.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLCellToVTKCellMap.h"
#include "vtkOpenGLIndexBufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkOpenGLVertexBufferObjectGroup.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"

#include <iterator>
#include <map>
#include <memory>

vtkStandardNewMacro(vtkWideFoVCompositeHelper);

struct vtkWideFoVCompositeHelper::Internals
{
  // One kind of primitives of a block.
  struct Block
  {
    explicit Block(bool strips)
      : Triangles(strips)
    {
    }
    wfv::MeshDraw Triangles;
    wfv::LineDraw Lines;
    bool Refined = false; // in this traversal
    bool Gone = false;    // the mapper has it no more
  };
  using Blocks = std::map<vtkPolyData*, std::unique_ptr<Block>>;

  Blocks Kinds[PrimitiveTriStrips + 1];    // of each kind of primitives
  wfv::RefinedDraw Nothing{ 3 };           // for blocks that are drawn as they are
  vtkOpenGLRenderWindow* Window = nullptr; // that is drawn to

  void Release(vtkWindow* window)
  {
    for (Blocks& blocks : this->Kinds)
    {
      for (auto& block : blocks)
      {
        block.second->Triangles.ReleaseGraphicsResources(window);
        block.second->Lines.ReleaseGraphicsResources(window);
      }
      blocks.clear();
    }
    this->Nothing.ReleaseGraphicsResources(window);
  }
};

vtkWideFoVCompositeHelper::vtkWideFoVCompositeHelper()
  : Internal(new Internals)
{
}

vtkWideFoVCompositeHelper::~vtkWideFoVCompositeHelper() = default;

void vtkWideFoVCompositeHelper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "RefinedBlocks: " << this->Internal->Kinds[PrimitiveTris].size() << "\n";
}

void vtkWideFoVCompositeHelper::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Internal->Release(window);
  this->Superclass::ReleaseGraphicsResources(window);
}

void vtkWideFoVCompositeHelper::Forget()
{
  for (Internals::Blocks& blocks : this->Internal->Kinds)
  {
    for (auto& block : blocks)
    {
      block.second->Gone = true;
      block.second->Refined = false;
    }
    this->ForEachBlock([&](vtkPolyData* data, const BlockOfMapper&) {
      const auto found = blocks.find(data);
      if (found != blocks.end())
      {
        found->second->Gone = false;
      }
    });
    for (auto it = blocks.begin(); it != blocks.end();)
    {
      it = it->second->Gone ? blocks.erase(it) : std::next(it);
    }
  }
}

bool vtkWideFoVCompositeHelper::IsDrawn(const BlockOfMapper& block, vtkActor* actor) const
{
  const auto& looks = LooksOf(block);
  if (this->CurrentSelector)
  {
    return looks.Visibility && looks.Pickability &&
      !actor->IsRenderingTranslucentPolygonalGeometry();
  }
  const bool opaque = looks.IsOpaque || actor->GetForceOpaque();
  const bool translucent = !looks.IsOpaque || actor->GetForceTranslucent();
  return looks.Visibility &&
    (actor->IsRenderingTranslucentPolygonalGeometry() ? translucent : opaque);
}

wfv::DrawnPart vtkWideFoVCompositeHelper::PartOf(const BlockOfMapper& block, int primitive)
{
  wfv::DrawnPart part;
  part.Helper = &this->Primitives[primitive];
  part.Buffers = this->VBOs;
  part.FirstVertex = block.StartVertex;
  part.Vertices = block.NextVertex - block.StartVertex;
  part.FirstIndex = block.StartIndex[primitive];
  part.Indices = block.NextIndex[primitive] - block.StartIndex[primitive];
  return part;
}

bool vtkWideFoVCompositeHelper::Refine(
  int primitive, bool lines, vtkActor* actor, vtkWideFoVStage* stage)
{
  const vtkMTimeType time = this->VBOBuildTime.GetMTime();
  Internals::Blocks& blocks = this->Internal->Kinds[primitive];
  bool any = false;
  this->ForEachBlock([&](vtkPolyData* data, const BlockOfMapper& record) {
    const wfv::DrawnPart part = this->PartOf(record, primitive);
    if (part.Indices == 0 || !this->IsDrawn(record, actor))
    {
      return;
    }
    std::unique_ptr<Internals::Block>& block = blocks[data];
    block = block ? std::move(block)
                  : std::make_unique<Internals::Block>(primitive == PrimitiveTriStrips);
    block->Refined = lines ? block->Lines.Prepare(part, time, actor, stage)
                           : block->Triangles.Prepare(data, actor, stage);
    any = any || block->Refined;
  });
  return any;
}

void vtkWideFoVCompositeHelper::SetCustomUniforms(vtkOpenGLHelper& cellBO, vtkActor* actor)
{
  if (this->Internal->Window)
  {
    this->Internal->Nothing.SetOwnNumbers(cellBO.Program, this->Internal->Window);
  }
  this->Superclass::SetCustomUniforms(cellBO, actor);
}

void vtkWideFoVCompositeHelper::DrawBlocks(
  int primitive, bool lines, vtkRenderer* renderer, vtkActor* actor)
{
  Internals& in = *this->Internal;
  vtkOpenGLHelper& helper = this->Primitives[primitive];
  this->UpdateShaders(helper, renderer, actor);
  if (!helper.Program)
  {
    return;
  }
  if (lines && !this->HaveWideLines(renderer, actor))
  {
    in.Window->GetState()->vtkglLineWidth(actor->GetProperty()->GetLineWidth());
  }
  this->PrimIDUsed = helper.Program->IsUniformUsed("PrimitiveIDOffset");
  this->OverideColorUsed = helper.Program->IsUniformUsed("OverridesColor");
  this->ForEachBlock([&](vtkPolyData* data, BlockOfMapper& record) {
    const auto found = in.Kinds[primitive].find(data);
    if (found == in.Kinds[primitive].end() || !found->second->Refined)
    {
      return;
    }
    Internals::Block& block = *found->second;
    this->SetShaderValues(
      helper.Program, &record, record.CellCellMap->GetPrimitiveOffsets()[primitive]);
    const wfv::DrawnPart part = this->PartOf(record, primitive);
    if (lines)
    {
      block.Lines.Draw(part, in.Window);
    }
    else
    {
      block.Triangles.Draw(part, in.Window);
    }
  });
}

bool vtkWideFoVCompositeHelper::DrawRefined(
  int primitive, vtkRenderer* renderer, vtkActor* actor, vtkWideFoVStage* stage)
{
  vtkProperty* const property = actor->GetProperty();
  const int mode = this->GetOpenGLMode(property->GetRepresentation(), primitive);
  const bool lines = mode == GL_LINES && !property->GetRenderLinesAsTubes();
  const bool edges = property->GetEdgeVisibility() && !this->CurrentSelector;
  if ((!lines && (mode != GL_TRIANGLES || edges)) || !this->Refine(primitive, lines, actor, stage))
  {
    return false;
  }
  this->DrawBlocks(primitive, lines, renderer, actor);
  return true;
}

// Draws triangles and lines refined. Everything else is drawn by the stock helper, which finds none
// of them left.
void vtkWideFoVCompositeHelper::RenderPieceDraw(vtkRenderer* renderer, vtkActor* actor)
{
  Internals& in = *this->Internal;
  in.Window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  this->CurrentSelector = renderer->GetSelector();
  this->DrawingVertices = this->DrawingSelection = false;
  this->PrimitiveIDOffset = 0;
  this->Forget();
  vtkWideFoVStage* const stage = wfv::Stages::FindAttached(actor);
  std::size_t counts[PrimitiveTriStrips + 1] = { 0 };
  for (int i = PrimitiveStart; i <= PrimitiveTriStrips; i++)
  {
    counts[i] = this->Primitives[i].IBO->IndexCount;
    if (stage && counts[i] > 0 && !this->PointPicking &&
      this->DrawRefined(i, renderer, actor, stage))
    {
      this->Primitives[i].IBO->IndexCount = 0;
    }
  }
  this->Superclass::RenderPieceDraw(renderer, actor);
  for (int i = PrimitiveStart; i <= PrimitiveTriStrips; i++)
  {
    this->Primitives[i].IBO->IndexCount = counts[i];
  }
  in.Nothing.Finish();
}
