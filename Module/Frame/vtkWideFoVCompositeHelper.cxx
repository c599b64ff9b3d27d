// SPDX-License-Identifier: BSD-3-Clause
#include "Frame/vtkWideFoVCompositeHelper.h"

#include "Frame/ClusterDraw.h"
#include "Frame/Stages.h"

#include "vtkActor.h"
#include "vtkHardwareSelector.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLCellToVTKCellMap.h"
#include "vtkOpenGLIndexBufferObject.h"
#include "vtkOpenGLVertexBufferObjectGroup.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <memory>

vtkStandardNewMacro(vtkWideFoVCompositeHelper);

namespace
{
using wfv::ClusterDraw;
}

struct vtkWideFoVCompositeHelper::Internals
{
  // A block's polygons or strips.
  struct Block
  {
    explicit Block(bool strips)
      : Triangles(strips)
    {
    }
    ClusterDraw Triangles;
    bool Classified = false; // in this traversal
    bool Gone = false;       // the mapper has it no more
  };

  // Of all blocks the polygons or the strips.
  struct Surfaces
  {
    std::map<vtkPolyData*, std::unique_ptr<Block>> Blocks;
    vtkOpenGLHelper Helpers[ClusterDraw::NumberOfKinds]; // the programs

    Block* Find(vtkPolyData* data) const
    {
      const auto found = this->Blocks.find(data);
      return found != this->Blocks.end() ? found->second.get() : nullptr;
    }

    void Release(vtkWindow* window)
    {
      for (auto& block : this->Blocks)
      {
        block.second->Triangles.ReleaseGraphicsResources(window);
      }
      this->Blocks.clear();
      for (vtkOpenGLHelper& helper : this->Helpers)
      {
        helper.ReleaseGraphicsResources(window);
      }
    }
  };

  Surfaces Polygons;
  Surfaces Strips;
  ClusterDraw Nothing{ false }; // for what is drawn in the order that it came in
  vtkWindow* Window = nullptr;  // that is drawn to

  Internals()
  {
    for (int i = 0; i < ClusterDraw::NumberOfKinds; i++)
    {
      this->Polygons.Helpers[i].PrimitiveType = PrimitiveTris;
      this->Strips.Helpers[i].PrimitiveType = PrimitiveTriStrips;
    }
  }

  Surfaces& Of(int primitive)
  {
    return primitive == PrimitiveTriStrips ? this->Strips : this->Polygons;
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
  os << indent << "ClassifiedBlocks: " << this->Internal->Polygons.Blocks.size() << "\n";
}

void vtkWideFoVCompositeHelper::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Internal->Polygons.Release(window);
  this->Internal->Strips.Release(window);
  this->Internal->Nothing.ReleaseGraphicsResources(window);
  this->Superclass::ReleaseGraphicsResources(window);
}

void vtkWideFoVCompositeHelper::Forget()
{
  for (Internals::Surfaces* surfaces : { &this->Internal->Polygons, &this->Internal->Strips })
  {
    auto& blocks = surfaces->Blocks;
    for (auto& block : blocks)
    {
      block.second->Gone = true;
    }
    this->ForEachBlock([&](vtkPolyData* data, const BlockOfMapper&) {
      if (Internals::Block* const found = surfaces->Find(data))
      {
        found->Gone = false;
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

bool vtkWideFoVCompositeHelper::Classify(int primitive, vtkActor* actor, vtkWideFoVStage* stage)
{
  const bool strips = primitive == PrimitiveTriStrips;
  auto& blocks = this->Internal->Of(primitive).Blocks;
  bool any = false;
  this->ForEachBlock([&](vtkPolyData* data, const BlockOfMapper& record) {
    if (!ClusterDraw::IsWorthIt(data, strips))
    {
      blocks.erase(data);
      return;
    }
    std::unique_ptr<Internals::Block>& block = blocks[data];
    block = block ? std::move(block) : std::make_unique<Internals::Block>(strips);
    block->Classified =
      this->IsDrawn(record, actor) && block->Triangles.Prepare(data, actor, stage);
    any = any || block->Classified;
  });
  return any;
}

void vtkWideFoVCompositeHelper::SetCustomUniforms(vtkOpenGLHelper& cellBO, vtkActor* actor)
{
  if (this->Internal->Window)
  {
    this->Internal->Nothing.SetParameters(cellBO.Program, this->Internal->Window);
  }
  this->Superclass::SetCustomUniforms(cellBO, actor);
}

// With the program that is bound, of the kind's own or of the stage's.
void vtkWideFoVCompositeHelper::DrawKind(int number, int primitive, vtkActor* actor)
{
  const auto kind = static_cast<ClusterDraw::Kind>(number);
  const Internals::Surfaces& surfaces = this->Internal->Of(primitive);
  vtkOpenGLHelper& own = this->Primitives[primitive];
  vtkShaderProgram* const program =
    kind == ClusterDraw::ByStage ? own.Program : surfaces.Helpers[kind].Program;
  this->ForEachBlock([&](vtkPolyData* data, BlockOfMapper& block) {
    Internals::Block* const known = surfaces.Find(data);
    const bool classified = known && known->Classified;
    wfv::DrawnPart part;
    part.FirstVertex = block.StartVertex;
    part.Vertices = block.NextVertex - block.StartVertex;
    part.FirstIndex = block.StartIndex[primitive];
    part.Indices = block.NextIndex[primitive] - block.StartIndex[primitive];
    const bool has =
      classified ? known->Triangles.Has(kind) : kind == ClusterDraw::ByStage && part.Indices > 0;
    if (!has || !this->IsDrawn(block, actor))
    {
      return;
    }
    this->SetShaderValues(program, &block, block.CellCellMap->GetPrimitiveOffsets()[primitive]);
    ClusterDraw& triangles = classified ? known->Triangles : this->Internal->Nothing;
    triangles.Choose(classified ? kind : ClusterDraw::All);
    triangles.SetParameters(program, this->Internal->Window);
    triangles.Draw(own.IBO, part);
    triangles.Finish();
  });
}

void vtkWideFoVCompositeHelper::DrawClusters(
  int primitive, vtkRenderer* renderer, vtkActor* actor, vtkWideFoVStage* stage)
{
  vtkOpenGLHelper& own = this->Primitives[primitive];
  Internals::Surfaces& surfaces = this->Internal->Of(primitive);
  for (int i = 0; i < ClusterDraw::NumberOfKinds; i++)
  {
    const auto kind = static_cast<ClusterDraw::Kind>(i);
    const bool byStage = kind == ClusterDraw::ByStage;
    const bool any = std::any_of(surfaces.Blocks.begin(), surfaces.Blocks.end(),
      [kind](const auto& b) { return b.second->Classified && b.second->Triangles.Has(kind); });
    if (!any && !byStage)
    {
      continue;
    }
    vtkWideFoVStage* const other = ClusterDraw::GetStage(kind, stage);
    vtkOpenGLHelper& helper = byStage ? own : surfaces.Helpers[kind];
    helper.IBO->IndexCount = own.IBO->IndexCount; // the others have none of their own
    wfv::Stages::Replace(actor, stage, other);
    this->UpdateShaders(helper, renderer, actor);
    if (helper.Program)
    {
      this->PrimIDUsed = helper.Program->IsUniformUsed("PrimitiveIDOffset");
      this->OverideColorUsed = helper.Program->IsUniformUsed("OverridesColor");
      this->DrawKind(kind, primitive, actor);
    }
    wfv::Stages::Replace(actor, other, stage);
  }
}

// What is classified is drawn here; everything else by the stock helper, which finds no triangles
// left.
void vtkWideFoVCompositeHelper::RenderPieceDraw(vtkRenderer* renderer, vtkActor* actor)
{
  Internals& in = *this->Internal;
  in.Window = renderer->GetRenderWindow();
  this->CurrentSelector = renderer->GetSelector();
  this->DrawingVertices = this->DrawingSelection = false;
  this->PrimitiveIDOffset = 0;
  this->Forget();
  vtkWideFoVStage* const stage = wfv::Stages::FindAttached(actor);
  vtkProperty* const property = actor->GetProperty();
  const bool edges = property->GetEdgeVisibility() && !this->CurrentSelector;
  const bool surface =
    stage && !this->PointPicking && !edges && property->GetRepresentation() == VTK_SURFACE;
  std::size_t counts[PrimitiveEnd] = { 0 };
  for (const int i : { PrimitiveTris, PrimitiveTriStrips })
  {
    counts[i] = this->Primitives[i].IBO->IndexCount;
    if (surface && counts[i] > 0 && this->Classify(i, actor, stage))
    {
      this->DrawClusters(i, renderer, actor, stage);
      this->Primitives[i].IBO->IndexCount = 0;
    }
  }
  this->Superclass::RenderPieceDraw(renderer, actor);
  for (const int i : { PrimitiveTris, PrimitiveTriStrips })
  {
    this->Primitives[i].IBO->IndexCount = counts[i];
  }
  in.Nothing.Finish();
}
