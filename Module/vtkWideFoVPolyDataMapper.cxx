// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWideFoVPolyDataMapper.h"

#include "vtkWideFoVCamera.h"
#include "vtkWideFoVPass.h"
#include "vtkWideFoVStage.h"

#include "vtkActor.h"
#include "vtkObjectFactory.h"
#include "vtkRenderer.h"

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
  vtkWideFoVStage* stage = stages.Choose(actor->GetBounds());
  vtkWideFoVStages::Attach(actor, stage);
  this->Superclass::RenderPiece(renderer, actor);
  vtkWideFoVStages::Detach(actor, stage);
}
