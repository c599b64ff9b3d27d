// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWideFoVPolyDataMapper.h"

#include "vtkWideFoVCamera.h"
#include "vtkWideFoVPass.h"
#include "vtkWideFoVStages.h"
#include "vtkWideFoVTessellation.h"

#include "vtkActor.h"
#include "vtkHardwareSelector.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLCellToVTKCellMap.h"
#include "vtkOpenGLIndexBufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkOpenGLVertexArrayObject.h"
#include "vtkOpenGLVertexBufferObjectGroup.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkWideFoVGl.h"

vtkStandardNewMacro(vtkWideFoVPolyDataMapper);

struct vtkWideFoVPolyDataMapper::Internals
{
  vtkWideFoVStages Stages;
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
  if (!camera || !camera->IsWide() || vtkWideFoVStages::IsAttached(actor))
  {
    this->Superclass::RenderPiece(renderer, actor);
    return;
  }
  vtkWideFoVStages& stages = this->Internal->Stages;
  stages.Begin(renderer, camera, this->Technique, this->Tolerance);
  stages.SetDebugView(this->DebugView != 0);
  vtkWideFoVStage* stage = stages.Choose(actor);
  vtkWideFoVStages::Attach(actor, stage);
  this->Superclass::RenderPiece(renderer, actor);
  vtkWideFoVStages::Detach(actor, stage);
  stages.End();
}

void vtkWideFoVPolyDataMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Internal->Stages.ReleaseGraphicsResources(window);
  this->Superclass::ReleaseGraphicsResources(window);
}

void vtkWideFoVPolyDataMapper::SetCustomUniforms(vtkOpenGLHelper& cellBO, vtkActor* actor)
{
  vtkWideFoVStage* stage = vtkWideFoVStages::FindAttached(actor);
  if (stage && stage->GetVariant() == vtkWideFoVShaderBuilder::Variant::Tessellate)
  {
    const vtkWideFoVShaderBuilder::Request request = stage->MakeRequest(this, actor);
    if (request.Stage == vtkWideFoVShaderBuilder::Variant::Tessellate &&
      !vtkWideFoVTessellation::IsIn(cellBO.Program))
    {
      const std::string log = vtkWideFoVTessellation::AddTo(cellBO.Program, request);
      if (!log.empty())
      {
        vtkErrorMacro(<< "the tessellation stages were refused: " << log);
      }
      // its attributes have new places
      cellBO.VAO->ReleaseGraphicsResources();
      cellBO.ShaderSourceTime.Modified();
    }
  }
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
  if (mode == GL_TRIANGLES && cellBO.Program && vtkWideFoVTessellation::IsIn(cellBO.Program))
  {
    vtkWideFoVTessellation::Draw(cellBO.Program, vertices, indices, this->PrimitiveIDOffset);
  }
  else
  {
    glDrawRangeElements(
      static_cast<GLenum>(mode), 0, vertices - 1, indices, GL_UNSIGNED_INT, nullptr);
  }
  cellBO.IBO->Release();
}

// Where patches may be among the primitives. The mode that the stock mapper draws them in
// cannot be overridden; everything else goes to it.
void vtkWideFoVPolyDataMapper::RenderPieceDraw(vtkRenderer* renderer, vtkActor* actor)
{
  vtkWideFoVStage* stage = vtkWideFoVStages::FindAttached(actor);
  const int representation = actor->GetProperty()->GetRepresentation();
  const bool edges = actor->GetProperty()->GetEdgeVisibility() && !renderer->GetSelector();
  if (!stage || stage->GetVariant() != vtkWideFoVShaderBuilder::Variant::Tessellate ||
    this->PointPicking || edges || representation != VTK_SURFACE)
  {
    this->Superclass::RenderPieceDraw(renderer, actor);
    return;
  }
  this->DrawingVertices = false;
  for (int i = PrimitiveStart; i <= PrimitiveTriStrips; i++)
  {
    this->DrawingSelection = false;
    if (this->Primitives[i].IBO->IndexCount)
    {
      this->DrawPrimitives(
        this->Primitives[i], this->GetOpenGLMode(representation, i), renderer, actor);
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
