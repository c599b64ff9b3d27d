// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWideFoVPolyDataMapper.h"

#include "Compat/Gl.h"
#include "Frame/LineDraw.h"
#include "Frame/MeshDraw.h"
#include "Frame/PropKeys.h"
#include "Frame/Stages.h"
#include "Frame/Technique.h"
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
  wfv::MeshDraw Polygons{ false };
  wfv::MeshDraw Strips{ true };
  wfv::LineDraw Lines[PrimitiveEnd];       // of each kind of primitives that is drawn as lines
  vtkOpenGLRenderWindow* Window = nullptr; // that is drawn to
  vtkWideFoVStage* Stage = nullptr;        // that is attached to the actor that is drawn

  wfv::MeshDraw& Of(int primitive)
  {
    return primitive == vtkOpenGLPolyDataMapper::PrimitiveTriStrips ? this->Strips : this->Polygons;
  }

  static wfv::DrawnPart PartOf(vtkOpenGLHelper& helper, vtkOpenGLVertexBufferObjectGroup* buffers)
  {
    wfv::DrawnPart part;
    part.Helper = &helper;
    part.Buffers = buffers;
    part.Vertices = static_cast<unsigned int>(buffers->GetNumberOfTuples("vertexMC"));
    part.Indices = helper.IBO->IndexCount;
    return part;
  }

  void Finish()
  {
    this->Polygons.Finish();
    this->Strips.Finish();
    for (wfv::LineDraw& lines : this->Lines)
    {
      lines.Finish();
    }
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

void vtkWideFoVPolyDataMapper::SetTechnique(int technique)
{
  const int number = wfv::TechniqueOf(technique);
  if (this->Technique != number)
  {
    this->Technique = number;
    this->Modified();
  }
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
  for (wfv::LineDraw& lines : this->Internal->Lines)
  {
    lines.ReleaseGraphicsResources(window);
  }
  this->Superclass::ReleaseGraphicsResources(window);
}

void vtkWideFoVPolyDataMapper::SetCustomUniforms(vtkOpenGLHelper& cellBO, vtkActor* actor)
{
  this->Internal->Of(cellBO.PrimitiveType).SetOwnNumbers(cellBO.Program, this->Internal->Window);
  this->Superclass::SetCustomUniforms(cellBO, actor);
}

// Draws triangles and lines refined, because no stock draw call takes pieces. Everything else is
// drawn by the superclass, which finds none of them left.
void vtkWideFoVPolyDataMapper::RenderPieceDraw(vtkRenderer* renderer, vtkActor* actor)
{
  Internals& in = *this->Internal;
  in.Window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  std::size_t counts[PrimitiveEnd] = { 0 };
  for (int i = PrimitiveStart; i < PrimitiveEnd; i++)
  {
    counts[i] = this->Primitives[i].IBO->IndexCount;
    if (i <= PrimitiveTriStrips && counts[i] > 0 && in.Stage && !this->PointPicking &&
      this->DrawRefined(i, renderer, actor))
    {
      this->Primitives[i].IBO->IndexCount = 0;
    }
  }
  this->Superclass::RenderPieceDraw(renderer, actor);
  for (int i = PrimitiveStart; i < PrimitiveEnd; i++)
  {
    this->Primitives[i].IBO->IndexCount = counts[i];
  }
  in.Finish();
}

bool vtkWideFoVPolyDataMapper::DrawRefined(int primitive, vtkRenderer* renderer, vtkActor* actor)
{
  Internals& in = *this->Internal;
  vtkProperty* const property = actor->GetProperty();
  const int mode = this->GetOpenGLMode(property->GetRepresentation(), primitive);
  const bool lines = mode == GL_LINES && !property->GetRenderLinesAsTubes();
  const bool edges = property->GetEdgeVisibility() && !renderer->GetSelector();
  if (!lines && (mode != GL_TRIANGLES || edges))
  {
    return false;
  }
  const wfv::DrawnPart part = Internals::PartOf(this->Primitives[primitive], this->VBOs);
  const bool refined = lines
    ? in.Lines[primitive].Prepare(part, this->VBOBuildTime.GetMTime(), actor, in.Stage)
    : in.Of(primitive).Prepare(this->CurrentInput, actor, in.Stage);
  if (!refined)
  {
    return false;
  }
  this->DrawingVertices = this->DrawingSelection = false;
  this->PrimitiveIDOffset = this->CellCellMap->GetPrimitiveOffsets()[primitive];
  this->UpdateShaders(*part.Helper, renderer, actor);
  if (lines)
  {
    if (!this->HaveWideLines(renderer, actor))
    {
      in.Window->GetState()->vtkglLineWidth(property->GetLineWidth());
    }
    in.Lines[primitive].Draw(part, in.Window);
  }
  else
  {
    in.Of(primitive).Draw(part, in.Window);
  }
  this->PrimitiveIDOffset = 0;
  return true;
}
