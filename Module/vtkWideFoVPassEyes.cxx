// SPDX-License-Identifier: BSD-3-Clause
// vtkWideFoVPass: props that are drawn for both eyes at once.
#include "vtkWideFoVPass.h"

#include "vtkWideFoVCamera.h"
#include "vtkWideFoVDriver.h"
#include "vtkWideFoVPassInternals.h"

#include "vtkInformation.h"
#include "vtkInformationObjectBaseVectorKey.h"
#include "vtkProp.h"
#include "vtkRenderState.h"
#include "vtkRenderWindow.h"

#include <algorithm>

namespace
{
// What may change from frame to frame: nothing shines through, and no other pass has a say.
bool SharesNow(vtkProp* prop)
{
  vtkInformation* const info = prop->GetPropertyKeys();
  return !(info && info->Has(vtkOpenGLRenderPass::RenderPasses())) &&
    !prop->HasTranslucentPolygonalGeometry();
}

// Nothing that the picture keeps from before, and nothing that is done with all of it between the
// props.
bool DrawsSimply(vtkRenderer* renderer)
{
  return renderer->GetErase() && renderer->GetRenderWindow()->GetErase() &&
    !renderer->Transparent() && !renderer->GetPreserveDepthBuffer() &&
    !renderer->GetTexturedBackground() && !renderer->GetSelector() && !renderer->GetUseShadows() &&
    !renderer->GetUseSSAO() && !renderer->GetUseFXAA() && !renderer->GetUseHiddenLineRemoval();
}
}

// In either number of traversals: which of two props at one depth shows follows from their order.
void vtkWideFoVPass::GatherShared(vtkProp** props, int count)
{
  Internals& in = *this->Internal;
  const vtkWideFoVStage* const both = in.Stages.ExactOfBoth;
  in.Shared = 0;
  if (std::find(in.Chosen.begin(), in.Chosen.end(), both) == in.Chosen.end())
  {
    return;
  }
  in.Others.clear();
  in.OtherStages.clear();
  for (int i = 0; i < count; i++)
  {
    vtkWideFoVStage* const stage = in.Chosen[i];
    if (stage == both && SharesNow(props[i]))
    {
      in.Chosen[in.Shared] = stage;
      props[in.Shared++] = props[i];
      continue;
    }
    in.Others.push_back(props[i]);
    in.OtherStages.push_back(stage == both ? in.Stages.Exact.Get() : stage);
  }
  std::copy(in.Others.begin(), in.Others.end(), props + in.Shared);
  std::copy(in.OtherStages.begin(), in.OtherStages.end(), in.Chosen.begin() + in.Shared);
}

bool vtkWideFoVPass::MayShare(const vtkRenderState* s, vtkProp** props)
{
  vtkRenderer* const renderer = s->GetRenderer();
  auto* const camera = vtkWideFoVCamera::SafeDownCast(renderer->GetActiveCamera());
  return this->EyesAtOnce == ALWAYS && !this->Internal->Delegate && !s->GetFrameBuffer() &&
    !s->GetRequiredKeys() && wfv::RendererAccess::Has(renderer, props) && camera &&
    camera->HasMirroredEyes() && DrawsSimply(renderer);
}

void vtkWideFoVPass::BeginShared(const vtkRenderState* s, vtkProp** props)
{
  Internals& in = *this->Internal;
  vtkRenderer* const renderer = s->GetRenderer();
  auto* const camera = vtkWideFoVCamera::SafeDownCast(renderer->GetActiveCamera());
  in.Frame = { renderer, camera->GetCurrentEye(), in.Stages.GetViewNumber(), this->GetMTime(),
    props, in.Shared };
  in.Role = in.Eyes.Begin(in.Frame, in.Shared > 0 && this->MayShare(s, props));
  if (in.Role == wfv::EyesAtOnce::Alone)
  {
    std::fill_n(in.Chosen.begin(), in.Shared, in.Stages.Exact.Get());
    return;
  }
  this->NumberOfSharedProps = in.Shared;
}

void vtkWideFoVPass::DrawShared(const vtkRenderState* s)
{
  Internals& in = *this->Internal;
  vtkRenderer* const renderer = s->GetRenderer();
  if (in.Role == wfv::EyesAtOnce::Alone)
  {
    this->UpdateGeometry(renderer, s->GetFrameBuffer());
    return;
  }
  in.Eyes.Draw(in.Frame, in.Role);
  wfv::RendererAccess::Skip(renderer, in.Shared);
  this->UpdateGeometry(renderer, s->GetFrameBuffer());
  wfv::RendererAccess::Skip(renderer, -in.Shared);
}
