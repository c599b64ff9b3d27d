// SPDX-License-Identifier: BSD-3-Clause
#include "Frame/vtkWideFoVCompositeHelper.h"

#include "Drawables/Kinds/DrawableKinds.h"
#include "Frame/BlockClusters.h"
#include "Frame/ClusterDraw.h"
#include "Frame/Stages.h"

#include "vtkActor.h"
#include "vtkCompositePolyDataMapper2.h"
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
#include <array>
#include <cstring>
#include <iterator>
#include <map>
#include <memory>
#include <string>

vtkStandardNewMacro(vtkWideFoVCompositeHelper);

namespace
{
using wfv::ClusterDraw;

// The names under which a composite mapper looks for the helpers of blocks with or without
// scalars (A), normals (B) and texture coordinates (C). Helpers that it does not ask for it drops.
std::array<std::string, 8> NamesOfKinds()
{
  std::array<std::string, 8> names;
  for (std::size_t i = 0; i < names.size(); i++)
  {
    const auto digit = [i](int bit) { return std::to_string((i >> bit) & 1); };
    names[i] = "A" + digit(0) + "B" + digit(1) + "C" + digit(2);
  }
  return names;
}

// What a composite mapper keeps to itself.
class MapperAccess : public vtkCompositePolyDataMapper2
{
public:
  static void Give(vtkCompositePolyDataMapper2* mapper, vtkWindow* window)
  {
    auto& helpers = mapper->*(&MapperAccess::Helpers);
    vtkTimeStamp& time = mapper->*(&MapperAccess::HelperMTime);
    for (auto& entry : helpers)
    {
      if (wfv::HasTrait(entry.second, wfv::DrawsBlocks) &&
        !wfv::HasTrait(entry.second, wfv::ClassifiesBlocks))
      {
        entry.second->ReleaseGraphicsResources(window);
        entry.second->Delete();
        entry.second = NewFor(mapper);
        time = vtkTimeStamp(); // so that the blocks are handed out anew
      }
    }
    vtkDataObject* const input = mapper->GetInputDataObject(0, 0);
    if (!input || (time > input->GetMTime() && time > mapper->GetMTime()))
    {
      return;
    }
    static const std::array<std::string, 8> names = NamesOfKinds();
    for (const std::string& name : names)
    {
      vtkCompositeMapperHelper2*& helper = helpers[name];
      helper = helper ? helper : NewFor(mapper);
    }
  }

private:
  static vtkCompositeMapperHelper2* NewFor(vtkCompositePolyDataMapper2* mapper)
  {
    auto* const helper = vtkWideFoVCompositeHelper::New();
    helper->SetParent(mapper);
    return helper;
  }
};
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

// Any other mapper, or one that makes helpers of a kind of its own, is left as it is.
void wfv::ClassifyBlocksOf(vtkMapper* mapper, vtkWindow* window)
{
  // a class derived from it may make helpers of its own
  if (wfv::HasTrait(mapper, wfv::StockComposite))
  {
    MapperAccess::Give(static_cast<vtkCompositePolyDataMapper2*>(mapper), window);
  }
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
    for (auto it = blocks.begin(); it != blocks.end();)
    {
      it = this->Data.count(it->first) > 0 ? std::next(it) : blocks.erase(it);
    }
  }
}

bool vtkWideFoVCompositeHelper::IsDrawn(
  const vtkCompositeMapperHelperData& block, vtkActor* actor) const
{
  if (this->CurrentSelector)
  {
    return block.Visibility && block.Pickability &&
      !actor->IsRenderingTranslucentPolygonalGeometry();
  }
  const bool opaque = block.IsOpaque || actor->GetForceOpaque();
  const bool translucent = !block.IsOpaque || actor->GetForceTranslucent();
  return block.Visibility &&
    (actor->IsRenderingTranslucentPolygonalGeometry() ? translucent : opaque);
}

bool vtkWideFoVCompositeHelper::Classify(int primitive, vtkActor* actor, vtkWideFoVStage* stage)
{
  const bool strips = primitive == PrimitiveTriStrips;
  auto& blocks = this->Internal->Of(primitive).Blocks;
  bool any = false;
  for (const auto& data : this->Data)
  {
    if (!ClusterDraw::IsWorthIt(data.first, strips))
    {
      blocks.erase(data.first);
      continue;
    }
    std::unique_ptr<Internals::Block>& block = blocks[data.first];
    block = block ? std::move(block) : std::make_unique<Internals::Block>(strips);
    block->Classified =
      this->IsDrawn(*data.second, actor) && block->Triangles.Prepare(data.first, actor, stage);
    any = any || block->Classified;
  }
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
  for (const auto& data : this->Data)
  {
    vtkCompositeMapperHelperData& block = *data.second;
    Internals::Block* const known = surfaces.Find(data.first);
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
      continue;
    }
    this->SetShaderValues(program, &block, block.CellCellMap->GetPrimitiveOffsets()[primitive]);
    ClusterDraw& triangles = classified ? known->Triangles : this->Internal->Nothing;
    triangles.Choose(classified ? kind : ClusterDraw::All);
    triangles.SetParameters(program, this->Internal->Window);
    triangles.Draw(own.IBO, part);
    triangles.Finish();
  }
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
