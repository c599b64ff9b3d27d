// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWideFoVPass.h"

#include "vtkWideFoVCamera.h"
#include "vtkWideFoVStages.h"

#include "vtkObjectFactory.h"
#include "vtkProp.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"

#include <vector>

vtkStandardNewMacro(vtkWideFoVPass);

struct vtkWideFoVPass::Internals
{
  vtkSmartPointer<vtkRenderPass> Delegate;
  vtkWideFoVStages Stages;
  std::vector<vtkWideFoVStage*> Chosen; // one a prop, kept between frames for its memory
};

vtkWideFoVPass::vtkWideFoVPass()
  : Internal(new Internals)
{
}

vtkWideFoVPass::~vtkWideFoVPass() = default;

void vtkWideFoVPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Technique: " << this->Technique << "\n"
     << indent << "Tolerance: " << this->Tolerance << "\n"
     << indent << "DebugView: " << this->DebugView << "\n"
     << indent << "DelegatePass: " << this->Internal->Delegate.Get() << "\n"
     << indent << "NumberOfPlainDraws: " << this->NumberOfPlainDraws << "\n"
     << indent << "NumberOfPreClipDraws: " << this->NumberOfPreClipDraws << "\n"
     << indent << "NumberOfExactDraws: " << this->NumberOfExactDraws << "\n"
     << indent << "NumberOfTessellateDraws: " << this->NumberOfTessellateDraws << "\n";
}

void vtkWideFoVPass::SetDelegatePass(vtkRenderPass* pass)
{
  if (this->Internal->Delegate != pass)
  {
    this->Internal->Delegate = pass;
    this->Modified();
  }
}

vtkRenderPass* vtkWideFoVPass::GetDelegatePass()
{
  return this->Internal->Delegate;
}

void vtkWideFoVPass::DrawDelegate(const vtkRenderState* s)
{
  if (this->Internal->Delegate)
  {
    this->Internal->Delegate->Render(s);
    this->NumberOfRenderedProps = this->Internal->Delegate->GetNumberOfRenderedProps();
    return;
  }
  vtkRenderer* renderer = s->GetRenderer();
  this->UpdateCamera(renderer);
  this->UpdateLightGeometry(renderer);
  this->UpdateLights(renderer);
  this->UpdateGeometry(renderer, s->GetFrameBuffer());
}

void vtkWideFoVPass::Render(const vtkRenderState* s)
{
  Internals& in = *this->Internal;
  vtkRenderer* renderer = s->GetRenderer();
  auto* camera = vtkWideFoVCamera::SafeDownCast(renderer->GetActiveCamera());
  this->NumberOfPlainDraws = 0;
  this->NumberOfPreClipDraws = 0;
  this->NumberOfExactDraws = 0;
  this->NumberOfTessellateDraws = 0;
  if (!camera || !camera->IsWide())
  {
    this->DrawDelegate(s);
    return;
  }
  camera->PrepareFrame(renderer);
  in.Stages.Begin(renderer, camera, this->Technique, this->Tolerance);
  in.Stages.SetDebugView(this->DebugView != 0);
  const int count = s->GetPropArrayCount();
  vtkProp** props = s->GetPropArray();
  in.Chosen.resize(count);
  for (int i = 0; i < count; i++)
  {
    in.Chosen[i] = in.Stages.Choose(props[i]);
    vtkWideFoVStages::Attach(props[i], in.Chosen[i]);
  }
  this->DrawDelegate(s);
  for (int i = 0; i < count; i++)
  {
    vtkWideFoVStages::Detach(props[i], in.Chosen[i]);
  }
  in.Stages.End();
  this->NumberOfPlainDraws = in.Stages.Plain->GetNumberOfDraws();
  // of the tessellate stage too, what cannot be tessellated is drawn by the pre-clip
  const int patches = in.Stages.Tessellate->GetNumberOfTessellateDraws();
  this->NumberOfPreClipDraws =
    in.Stages.PreClip->GetNumberOfDraws() + in.Stages.Tessellate->GetNumberOfDraws() - patches;
  this->NumberOfTessellateDraws = patches;
  this->NumberOfExactDraws = in.Stages.Exact->GetNumberOfDraws();
}

void vtkWideFoVPass::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Internal->Stages.ReleaseGraphicsResources(window);
  if (this->Internal->Delegate)
  {
    this->Internal->Delegate->ReleaseGraphicsResources(window);
  }
  this->Superclass::ReleaseGraphicsResources(window);
}
