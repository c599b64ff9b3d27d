// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWideFoVPolyDataMapper.h"

#include "Compat/Gl.h"
#include "Frame/ClusterDraw.h"
#include "Frame/PropKeys.h"
#include "Frame/RefusedShaders.h"
#include "Frame/Stages.h"
#include "Frame/Tessellation.h"
#include "vtkWideFoVCamera.h"
#include "vtkWideFoVPass.h"

#include "vtkActor.h"
#include "vtkHardwareSelector.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLCellToVTKCellMap.h"
#include "vtkOpenGLIndexBufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkOpenGLVertexArrayObject.h"
#include "vtkOpenGLVertexBufferObjectGroup.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkShader.h"
#include "vtkShaderProgram.h"

vtkStandardNewMacro(vtkWideFoVPolyDataMapper);

struct vtkWideFoVPolyDataMapper::Internals
{
  wfv::Stages Stages;
  wfv::PropKeys Keys; // of the actor that is drawn, where no pass draws it
  wfv::ClusterDraw Polygons{ false };
  wfv::ClusterDraw Strips{ true };
  vtkWindow* Window = nullptr;      // that is drawn to
  vtkWideFoVStage* Stage = nullptr; // that is attached to the actor that is drawn

  wfv::ClusterDraw& Of(int primitive)
  {
    return primitive == vtkOpenGLPolyDataMapper::PrimitiveTriStrips ? this->Strips : this->Polygons;
  }
};

vtkWideFoVPolyDataMapper::vtkWideFoVPolyDataMapper()
  : Internal(new Internals)
{
}

vtkWideFoVPolyDataMapper::~vtkWideFoVPolyDataMapper() = default;

void vtkWideFoVPolyDataMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Technique: " << this->Technique << "\n"
     << indent << "Tolerance: " << this->Tolerance << "\n"
     << indent << "DebugView: " << this->DebugView << "\n";
}

void vtkWideFoVPolyDataMapper::RenderPiece(vtkRenderer* renderer, vtkActor* actor)
{
  auto* camera = vtkWideFoVCamera::SafeDownCast(renderer->GetActiveCamera());
  vtkWideFoVStage*& stage = this->Internal->Stage;
  stage = wfv::Stages::FindAttached(actor);
  if (!camera || !camera->IsWide() || stage)
  {
    this->Superclass::RenderPiece(renderer, actor);
    return;
  }
  wfv::Stages& stages = this->Internal->Stages;
  const double* const bounds = actor->GetBounds();
  wfv::PropTraits traits;
  stages.Begin(renderer, camera, this->Technique, this->Tolerance);
  stages.SetDebugView(this->DebugView != 0);
  if (stages.IsCulled(actor, bounds, traits))
  {
    return;
  }
  stage = stages.Choose(actor, bounds, traits);
  this->Internal->Keys.Attach(actor, stage);
  this->Superclass::RenderPiece(renderer, actor);
  this->Internal->Keys.Detach(actor, stage);
  stages.End();
}

void vtkWideFoVPolyDataMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Internal->Stages.ReleaseGraphicsResources(window);
  this->Internal->Polygons.ReleaseGraphicsResources(window);
  this->Internal->Strips.ReleaseGraphicsResources(window);
  this->Superclass::ReleaseGraphicsResources(window);
}

void vtkWideFoVPolyDataMapper::SetCustomUniforms(vtkOpenGLHelper& cellBO, vtkActor* actor)
{
  vtkWideFoVStage* const stage = this->Internal->Stage;
  if (stage && stage->GetVariant() == wfv::ShaderBuilder::Variant::Tessellate &&
    !wfv::Tessellation::IsIn(cellBO.Program))
  {
    const wfv::ShaderBuilder::Request request = stage->MakeRequest(this, actor);
    // (one that draws nothing has no geometry stage)
    if (request.Stage == wfv::ShaderBuilder::Variant::Tessellate &&
      !cellBO.Program->GetGeometryShader()->GetSource().empty())
    {
      const std::string log = wfv::Tessellation::AddTo(cellBO.Program, request);
      if (!log.empty())
      {
        wfv::ReportRefused(this, "tessellation shaders", log, "its triangles are drawn whole");
      }
      stage->GetStages()->Programs.Forget(cellBO.Program);
      // its attributes have new places
      cellBO.VAO->ReleaseGraphicsResources();
      cellBO.ShaderSourceTime.Modified();
    }
  }
  this->Internal->Of(cellBO.PrimitiveType).SetParameters(cellBO.Program, this->Internal->Window);
  this->Superclass::SetCustomUniforms(cellBO, actor);
}

void vtkWideFoVPolyDataMapper::DrawPrimitives(
  vtkOpenGLHelper& cellBO, int mode, vtkRenderer* renderer, vtkActor* actor)
{
  this->UpdateShaders(cellBO, renderer, actor);
  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  if (mode == GL_LINES && !this->HaveWideLines(renderer, actor))
  {
    window->GetState()->vtkglLineWidth(actor->GetProperty()->GetLineWidth());
  }
  const auto vertices = static_cast<GLuint>(this->VBOs->GetNumberOfTuples("vertexMC"));
  const auto indices = static_cast<int>(cellBO.IBO->IndexCount);
  cellBO.IBO->Bind();
  if (mode == GL_TRIANGLES && cellBO.Program && wfv::Tessellation::IsIn(cellBO.Program))
  {
    wfv::Tessellation::Draw(cellBO.Program, vertices, indices, this->PrimitiveIDOffset);
  }
  else
  {
    glDrawRangeElements(
      static_cast<GLenum>(mode), 0, vertices - 1, indices, GL_UNSIGNED_INT, nullptr);
  }
  cellBO.IBO->Release();
}

// Projected ones with a program of their own, the others with the one that the stage asks for.
void vtkWideFoVPolyDataMapper::DrawClusters(int primitive, vtkRenderer* renderer, vtkActor* actor)
{
  wfv::ClusterDraw& clusters = this->Internal->Of(primitive);
  vtkOpenGLHelper& own = this->Primitives[primitive];
  wfv::DrawnPart part;
  part.Vertices = static_cast<unsigned int>(this->VBOs->GetNumberOfTuples("vertexMC"));
  part.Indices = own.IBO->IndexCount;
  vtkWideFoVStage* const stage = wfv::Stages::FindAttached(actor);
  for (int i = 0; i < wfv::ClusterDraw::NumberOfKinds; i++)
  {
    const auto kind = static_cast<wfv::ClusterDraw::Kind>(i);
    if (!clusters.Has(kind))
    {
      continue;
    }
    const bool byStage = kind == wfv::ClusterDraw::ByStage;
    vtkWideFoVStage* const other = wfv::ClusterDraw::GetStage(kind, stage);
    vtkOpenGLHelper& helper = byStage ? own : clusters.GetHelper(kind);
    helper.IBO->IndexCount = own.IBO->IndexCount; // the other has none of its own
    wfv::Stages::Replace(actor, stage, other);
    clusters.Choose(kind);
    this->UpdateShaders(helper, renderer, actor);
    clusters.Draw(own.IBO, part);
    wfv::Stages::Replace(actor, other, stage);
  }
  clusters.Choose(wfv::ClusterDraw::All);
}

// Where patches may be among the primitives, or clusters have classes. The mode that the stock
// mapper draws them in cannot be overridden; everything else goes to it.
void vtkWideFoVPolyDataMapper::RenderPieceDraw(vtkRenderer* renderer, vtkActor* actor)
{
  this->Internal->Window = renderer->GetRenderWindow();
  vtkWideFoVStage* const stage = this->Internal->Stage;
  vtkProperty* const property = actor->GetProperty();
  const bool edges = property->GetEdgeVisibility() && !renderer->GetSelector();
  const bool surface =
    stage && !this->PointPicking && !edges && property->GetRepresentation() == VTK_SURFACE;
  const bool patches = surface && stage->GetVariant() == wfv::ShaderBuilder::Variant::Tessellate;
  bool classified[PrimitiveEnd] = { false };
  if (surface && !patches)
  {
    for (const int i : { PrimitiveTris, PrimitiveTriStrips })
    {
      classified[i] = this->Internal->Of(i).Prepare(this->CurrentInput, actor, stage);
    }
  }
  if (patches || classified[PrimitiveTris] || classified[PrimitiveTriStrips])
  {
    this->DrawSurface(renderer, actor, classified);
  }
  else
  {
    this->Superclass::RenderPieceDraw(renderer, actor);
  }
  this->Internal->Polygons.Finish();
  this->Internal->Strips.Finish();
}

// As the stock mapper does it, but for the triangles. classified: of each primitive, whether.
void vtkWideFoVPolyDataMapper::DrawSurface(
  vtkRenderer* renderer, vtkActor* actor, const bool* classified)
{
  this->DrawingVertices = false;
  for (int i = PrimitiveStart; i <= PrimitiveTriStrips; i++)
  {
    this->DrawingSelection = false;
    if (this->Primitives[i].IBO->IndexCount)
    {
      if (classified[i])
      {
        this->DrawClusters(i, renderer, actor);
      }
      else
      {
        this->DrawPrimitives(
          this->Primitives[i], this->GetOpenGLMode(VTK_SURFACE, i), renderer, actor);
      }
      this->PrimitiveIDOffset =
        i < PrimitiveTriStrips ? this->CellCellMap->GetPrimitiveOffsets()[i + 1] : 0;
    }
    this->DrawingSelection = true;
    if (this->SelectionPrimitives[i].IBO->IndexCount)
    {
      this->DrawPrimitives(
        this->SelectionPrimitives[i], this->GetOpenGLMode(this->SelectionType, i), renderer, actor);
    }
  }
}
