// SPDX-License-Identifier: BSD-3-Clause
// vtkWideFoVPass: what stands before what.
#include "vtkWideFoVPass.h"

#include "vtkWideFoVPassInternals.h"

#include "vtkRenderState.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

namespace
{
// Frames that a scene has stood before hidden triangles are looked for: it takes about as long as
// to draw them a few times.
constexpr int StillFrames = 10;
}

// Depths are those of this frame's props alone, drawn one after the other.
bool vtkWideFoVPass::MayHide(const vtkRenderState* s, vtkProp** props)
{
  vtkRenderer* const renderer = s->GetRenderer();
  return this->OcclusionCulling && this->Culling && !this->Internal->Delegate &&
    !s->GetFrameBuffer() && !s->GetRequiredKeys() && wfv::RendererAccess::Has(renderer, props) &&
    renderer->GetErase() && renderer->GetRenderWindow()->GetErase() &&
    !renderer->GetPreserveDepthBuffer() && !renderer->GetUseHiddenLineRemoval() &&
    (this->Technique == AUTO || this->Technique == EXACT) && this->Relaxation == 0 &&
    this->Internal->Role == wfv::EyesAtOnce::Alone;
}

void vtkWideFoVPass::BeginHidden(const vtkRenderState* s, vtkProp** props)
{
  Internals& in = *this->Internal;
  wfv::HiddenScene& scene = in.Stages.Hidden;
  const bool selects = s->GetRenderer()->GetSelector() != nullptr;
  scene.SetPaused(selects);
  if (selects)
  {
    return;
  }
  const vtkProp* last = nullptr;
  std::size_t drawn = 0;
  wfv::HiddenScene::Props& known = scene.GetProps();
  known.clear();
  if (this->MayHide(s, props))
  {
    for (int i = 0; i < in.Props.GetCount() && in.Props.GetFacts(i).Tells; i++)
    {
      vtkProp* const prop = in.Props.GetProp(i);
      known.emplace_back(prop, in.Props.GetNumber(i));
      const bool sorts = in.Props.GetFacts(i).Sorts && !in.Props.IsUnseen(i);
      if (sorts && prop->HasOpaqueGeometry())
      {
        last = prop;
        drawn = known.size();
      }
    }
  }
  // in stereo some that come later may be drawn before
  known.resize(in.Shared > 0 ? known.size() : drawn);
  scene.Begin(last, in.Stages.GetViewNumber(), this->SortWhileMoving ? 1 : StillFrames);
}
