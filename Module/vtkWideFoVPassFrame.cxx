// SPDX-License-Identifier: BSD-3-Clause
// vtkWideFoVPass: what a wide frame draws, and to where.
#include "Camera/Tile.h"
#include "Compat/Reports.h"
#include "Drawables/Kinds/DrawableKinds.h"
#include "Drawables/PointLabels.h"
#include "Drawables/Sky.h"
#include "Frame/BlockClusters.h"
#include "Frame/FlatDraws.h"
#include "Frame/PartActor.h"
#include "Frame/StockEffects.h"
#include "PassChain.h"
#include "vtkWideFoVCamera.h"
#include "vtkWideFoVPass.h"
#include "vtkWideFoVPassInternals.h"

#include "vtkActor.h"
#include "vtkFrameBufferObjectBase.h"
#include "vtkMapper2D.h"
#include "vtkProp.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <string>

void vtkWideFoVPass::DrawDelegate(const vtkRenderState* s)
{
  vtkRenderPass* const delegate = this->Internal->Delegate;
  if (delegate && !this->InDelegate && !(this->Draws && wfv::FindFlatPass(delegate)))
  {
    this->InDelegate = true; // it may call this one
    delegate->Render(s);
    this->InDelegate = false;
    this->NumberOfRenderedProps = delegate->GetNumberOfRenderedProps();
    return;
  }
  vtkRenderer* renderer = s->GetRenderer();
  this->UpdateCamera(renderer);
  this->UpdateLightGeometry(renderer);
  this->UpdateLights(renderer);
  this->UpdateGeometry(renderer, s->GetFrameBuffer());
}

namespace
{
bool IsPointLabels(vtkProp* prop)
{
  auto* const actor = vtkActor2D::SafeDownCast(prop);
  return actor && wfv::HasTrait(actor->GetMapper(), wfv::PointLabels);
}
}

namespace
{
void WarnOfMeasure(vtkProp* prop)
{
  if (wfv::HasTrait(prop, wfv::MeasuresPicture) &&
    wfv::IsNews(std::string("measure ") + prop->GetClassName()))
  {
    vtkWarningWithObjectMacro(prop, << prop->GetClassName()
                                    << " says other lengths than are seen: a wide picture has no "
                                       "one scale");
  }
}
}

int vtkWideFoVPass::Cull(vtkProp** props, bool selects)
{
  Internals& in = *this->Internal;
  int seen = 0;
  in.Chosen.clear();
  in.Texts.Clear();
  in.Flat.clear();
  in.Labels.clear();
  for (int i = 0; i < in.Props.GetCount(); i++)
  {
    vtkProp* const prop = in.Props.GetProp(i);
    WarnOfMeasure(prop);
    auto* const flat = in.Enlargement > 0 ? vtkActor2D::SafeDownCast(prop) : nullptr;
    if (IsPointLabels(prop))
    {
      in.Labels.push_back(static_cast<vtkActor2D*>(prop));
    }
    else if (flat)
    {
      in.Flat.push_back(flat);
    }
    else if (!in.Texts.Take(prop) && !in.Props.IsCulled(i) && !wfv::sky::IsLeftOut(prop, selects))
    {
      in.Chosen.push_back(in.Props.GetStage(i));
      props[seen++] = prop;
    }
  }
  return seen;
}

void vtkWideFoVPass::DrawProps(const vtkRenderState* s, vtkProp** props, int count)
{
  Internals& in = *this->Internal;
  in.Keys.resize(std::max<std::size_t>(in.Keys.size(), count));
  const double aspect = wfv::PictureAspect(s->GetRenderer());
  const bool selects = s->GetRenderer()->GetSelector() != nullptr;
  for (int i = 0; i < count; i++)
  {
    in.Keys[i].Attach(props[i], in.Chosen[i]);
    if (auto* const actor = vtkActor::SafeDownCast(props[i]))
    {
      wfv::ClassifyBlocksOf(actor->GetMapper(), s->GetRenderer()->GetRenderWindow());
    }
    in.Habits.Stop(props[i], in.Camera, aspect);
    for (const vtkSmartPointer<vtkProp>& part : in.Parts.Attach(props[i], in.Stages, selects))
    {
      in.Habits.Stop(part, in.Camera, aspect);
    }
  }
  vtkRenderState seen(s->GetRenderer());
  seen.SetFrameBuffer(s->GetFrameBuffer());
  seen.SetRequiredKeys(s->GetRequiredKeys());
  seen.SetPropArrayAndCount(props, count);
  {
    const wfv::WithoutStockEffects without(s->GetRenderer());
    this->DrawDelegate(&seen);
  }
  if (in.Camera->TakeFlatDraws() > 0)
  {
    wfv::WarnOfFlatDraws(this, { props, props + count }, in.Stages.DrawnKeys);
  }
  in.Habits.Restore();
  in.Parts.Detach();
  for (int i = 0; i < count; i++)
  {
    in.Keys[i].Detach(props[i], in.Chosen[i]);
  }
}

void vtkWideFoVPass::BeginFrame(const vtkRenderState* s, vtkWideFoVCamera* camera)
{
  Internals& in = *this->Internal;
  vtkRenderer* const renderer = s->GetRenderer();
  double bounds[6];
  int drawn[2];
  const bool framebuffer = this->FindFramebuffer(s, drawn);
  camera->BeginFrame(renderer, in.Props.GetSceneBounds(renderer, bounds) ? bounds : nullptr,
    framebuffer ? drawn : nullptr);
  camera->TakeFlatDraws();
  in.Camera = camera;
}

void vtkWideFoVPass::DrawLabels(vtkRenderer* renderer)
{
  Internals& in = *this->Internal;
  const auto up = static_cast<wfv::LabelUp>(this->LabelUp);
  in.Camera->SetNothingBehind(true);
  for (vtkActor2D* const labels : in.Labels)
  {
    wfv::DrawPointLabels(labels, renderer, in.Camera, up);
  }
  in.Camera->SetNothingBehind(false);
  in.Texts.Draw(renderer, in.Camera, in.Stages.Projected->GetTile(), up);
}

// Of a pass over the picture, which may be larger. What that draws by a copy of the camera has a
// border beyond the picture, and all others have larger pixels.
bool vtkWideFoVPass::FindFramebuffer(const vtkRenderState* s, int size[2])
{
  Internals& in = *this->Internal;
  vtkFrameBufferObjectBase* const framebuffer = s->GetFrameBuffer();
  int border = 0;
  if (framebuffer)
  {
    framebuffer->GetLastSize(size);
    border = in.OfCopy ? std::max(0, (size[0] - s->GetRenderer()->GetSize()[0]) / 2) : 0;
  }
  in.Stages.SetBorder(border);
  return framebuffer != nullptr;
}

void vtkWideFoVPass::DrawSeen(const vtkRenderState* s, int seen)
{
  Internals& in = *this->Internal;
  if (in.Enlargement > 0)
  {
    // the programs are those for the samples of the window; depth is ordered in this framebuffer
    in.Small.Begin();
    in.Stages.Fine.Begin(s->GetRenderer());
  }
  this->Draws = true;
  {
    const auto up = static_cast<wfv::LabelUp>(this->LabelUp);
    const wfv::FrameInDrawing frame(s->GetRenderer(), &in.Stages, up);
    this->DrawProps(s, s->GetPropArray(), seen);
  }
  this->Draws = false;
  if (in.Enlargement > 0)
  {
    in.Small.End();
    for (vtkActor2D* const flat : in.Flat)
    {
      wfv::DrawOverlay(flat, s->GetRenderer());
    }
  }
}
