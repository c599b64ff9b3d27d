// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWideFoVPass.h"

#include "vtkWideFoVCamera.h"
#include "vtkWideFoVHeadlights.h"
#include "vtkWideFoVScreenCamera.h"
#include "vtkWideFoVStages.h"

#include "vtkObjectFactory.h"
#include "vtkProp.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <vector>

vtkStandardNewMacro(vtkWideFoVPass);

struct vtkWideFoVPass::Internals
{
  vtkSmartPointer<vtkRenderPass> Delegate;
  vtkWideFoVStages Stages;
  vtkNew<vtkWideFoVHeadlights> Headlights; // of flat screens
  std::vector<vtkWideFoVStage*> Chosen;    // one a prop, kept between frames for its memory
  std::vector<vtkProp*> Order;             // the props as they came
};

namespace
{
// The renderer's own list is what its stock passes go through.
class RendererAccess : public vtkRenderer
{
public:
  static void SetCount(vtkRenderer* renderer, vtkProp** props, int count)
  {
    if (renderer->*(&RendererAccess::PropArray) == props)
    {
      renderer->*(&RendererAccess::PropArrayCount) = count;
    }
  }
};
}

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
     << indent << "NumberOfTessellateDraws: " << this->NumberOfTessellateDraws << "\n"
     << indent << "Culling: " << this->Culling << "\n"
     << indent << "NumberOfDrawnProps: " << this->NumberOfDrawnProps << "\n"
     << indent << "NumberOfCulledProps: " << this->NumberOfCulledProps << "\n"
     << indent << "NumberOfClusters: " << this->NumberOfClusters << "\n"
     << indent << "NumberOfCulledClusters: " << this->NumberOfCulledClusters << "\n";
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

int vtkWideFoVPass::Cull(vtkProp** props, int count)
{
  vtkProp** const end = std::stable_partition(
    props, props + count, [this](vtkProp* prop) { return !this->Internal->Stages.IsUnseen(prop); });
  return static_cast<int>(end - props);
}

void vtkWideFoVPass::DrawProps(const vtkRenderState* s, vtkProp** props, int count)
{
  Internals& in = *this->Internal;
  in.Chosen.resize(count);
  for (int i = 0; i < count; i++)
  {
    in.Chosen[i] = in.Stages.Choose(props[i]);
    vtkWideFoVStages::Attach(props[i], in.Chosen[i]);
  }
  vtkRenderState seen(s->GetRenderer());
  seen.SetFrameBuffer(s->GetFrameBuffer());
  seen.SetRequiredKeys(s->GetRequiredKeys());
  seen.SetPropArrayAndCount(props, count);
  this->DrawDelegate(&seen);
  for (int i = 0; i < count; i++)
  {
    vtkWideFoVStages::Detach(props[i], in.Chosen[i]);
  }
}

void vtkWideFoVPass::Render(const vtkRenderState* s)
{
  Internals& in = *this->Internal;
  vtkRenderer* renderer = s->GetRenderer();
  auto* camera = vtkWideFoVCamera::SafeDownCast(renderer->GetActiveCamera());
  const int count = s->GetPropArrayCount();
  this->NumberOfPlainDraws = this->NumberOfPreClipDraws = 0;
  this->NumberOfExactDraws = this->NumberOfTessellateDraws = 0;
  this->NumberOfClusters = this->NumberOfCulledClusters = 0;
  this->NumberOfCulledProps = 0;
  this->NumberOfDrawnProps = count;
  if (vtkWideFoVScreenCamera::SafeDownCast(camera))
  {
    in.Headlights->Begin(s);
    this->DrawDelegate(s);
    in.Headlights->End(s);
    return;
  }
  if (!camera || !camera->IsWide())
  {
    this->DrawDelegate(s);
    return;
  }
  camera->PrepareFrame(renderer);
  in.Stages.SetCulling(this->Culling != 0);
  in.Stages.Begin(renderer, camera, this->Technique, this->Tolerance);
  in.Stages.SetDebugView(this->DebugView != 0);
  vtkProp** props = s->GetPropArray();
  in.Order.assign(props, props + count);
  const int seen = this->Cull(props, count);
  RendererAccess::SetCount(renderer, props, seen);
  this->DrawProps(s, props, seen);
  RendererAccess::SetCount(renderer, props, count);
  std::copy(in.Order.begin(), in.Order.end(), props);
  in.Stages.End();
  this->NumberOfDrawnProps = seen;
  this->NumberOfCulledProps = count - seen;
  this->TakeCounts();
}

void vtkWideFoVPass::TakeCounts()
{
  const vtkWideFoVStages& stages = this->Internal->Stages;
  this->NumberOfPlainDraws =
    stages.Plain->GetNumberOfDraws() + stages.PlainAmong->GetNumberOfDraws();
  // of the tessellate stage too, what cannot be tessellated is drawn by the pre-clip
  const int patches = stages.Tessellate->GetNumberOfTessellateDraws();
  const int calm = stages.CalmAmong->GetNumberOfDraws();
  const bool exact = this->Technique == EXACT;
  this->NumberOfPreClipDraws = stages.PreClip->GetNumberOfDraws() +
    stages.Tessellate->GetNumberOfDraws() - patches + (exact ? 0 : calm);
  this->NumberOfTessellateDraws = patches;
  this->NumberOfExactDraws = stages.Exact->GetNumberOfDraws() + (exact ? calm : 0);
  this->NumberOfClusters = stages.GetNumberOfClusters();
  this->NumberOfCulledClusters = stages.GetNumberOfUnseenClusters();
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
