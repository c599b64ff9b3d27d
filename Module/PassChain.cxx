// SPDX-License-Identifier: BSD-3-Clause
#include "PassChain.h"

#include "Compat/Reports.h"
#include "vtkWideFoVDataPass.h"
#include "vtkWideFoVPass.h"

#include "vtkCameraPass.h"
#include "vtkDepthImageProcessingPass.h"
#include "vtkImageProcessingPass.h"
#include "vtkRenderPassCollection.h"
#include "vtkRenderStepsPass.h"
#include "vtkSSAAPass.h"
#include "vtkSequencePass.h"

#include <algorithm>
#include <iterator>
#include <string>

namespace
{
// Of passes over the picture there are two kinds.
bool IsOverPicture(vtkRenderPass* pass)
{
  return vtkImageProcessingPass::SafeDownCast(pass) || vtkSSAAPass::SafeDownCast(pass);
}

vtkRenderPass* GetDelegate(vtkRenderPass* pass)
{
  auto* const image = vtkImageProcessingPass::SafeDownCast(pass);
  return image ? image->GetDelegatePass() : vtkSSAAPass::SafeDownCast(pass)->GetDelegatePass();
}

void SetDelegate(vtkRenderPass* pass, vtkRenderPass* inner)
{
  if (auto* const image = vtkImageProcessingPass::SafeDownCast(pass))
  {
    image->SetDelegatePass(inner);
    return;
  }
  vtkSSAAPass::SafeDownCast(pass)->SetDelegatePass(inner);
}

// Of passes over the picture: those that make places of its depths.
bool ReckonsInDepth(vtkRenderPass* pass)
{
  return vtkDepthImageProcessingPass::SafeDownCast(pass) || pass->IsA("vtkSSAOPass");
}

// Why one over the picture is left out, or nullptr where it is not.
const char* WhyLeftOut(vtkRenderPass* pass)
{
  if (ReckonsInDepth(pass))
  {
    return "it takes the depths of the picture for those of a perspective";
  }
  return pass->IsA("vtkPanoramicProjectionPass")
    ? "it makes a projection of pictures in perspective; see SetProjection of vtkWideFoVCamera"
    : nullptr;
}

bool IsShadow(vtkRenderPass* pass)
{
  return pass->IsA("vtkShadowMapPass") || pass->IsA("vtkShadowMapBakerPass");
}

// Once a process for each class of pass.
void WarnOnce(vtkRenderPass* pass, const char* why)
{
  const std::string name = pass->GetClassName();
  if (wfv::IsNews("pass " + name))
  {
    vtkWarningWithObjectMacro(pass, << name << " is left out in a wide view: " << why);
  }
}

// VTK's own that draw props or call others, none of which draws a wide view.
bool IsStock(vtkRenderPass* pass)
{
  static constexpr const char* names[] = { "vtkCameraPass", "vtkClearRGBPass", "vtkClearZPass",
    "vtkCompositeRGBAPass", "vtkCompositeZPass", "vtkDefaultPass", "vtkDepthPeelingPass",
    "vtkHiddenLineRemovalPass", "vtkImageProcessingPass", "vtkLightsPass",
    "vtkOrderIndependentTranslucentPass", "vtkRenderStepsPass", "vtkSSAAPass", "vtkSequencePass",
    "vtkShadowMapBakerPass", "vtkShadowMapPass", "vtkWideFoVDataPass" };
  return std::any_of(
    std::begin(names), std::end(names), [pass](const char* name) { return pass->IsA(name); });
}

// Whatever else there is may call a wide pass that cannot be seen from here, such as ParaView's for
// several ranks.
bool MayBeWide(vtkRenderPass* pass)
{
  return vtkWideFoVPass::SafeDownCast(pass) || !IsStock(pass);
}

using Question = bool (*)(vtkRenderPass*);
vtkRenderPass* Find(vtkRenderPass* pass, Question asked);

vtkRenderPass* FindInSequence(vtkSequencePass* sequence, Question asked)
{
  vtkRenderPassCollection* const passes = sequence->GetPasses();
  vtkCollectionSimpleIterator it;
  if (passes)
  {
    passes->InitTraversal(it);
  }
  while (vtkRenderPass* const pass = passes ? passes->GetNextRenderPass(it) : nullptr)
  {
    if (vtkRenderPass* const found = Find(pass, asked))
    {
      return found;
    }
  }
  return nullptr;
}

// The first one that it is true of: the pass, or one that it calls.
vtkRenderPass* Find(vtkRenderPass* pass, Question asked)
{
  if (!pass || asked(pass))
  {
    return pass;
  }
  if (IsOverPicture(pass))
  {
    return Find(GetDelegate(pass), asked);
  }
  if (auto* const camera = vtkCameraPass::SafeDownCast(pass))
  {
    return Find(camera->GetDelegatePass(), asked);
  }
  if (auto* const data = vtkWideFoVDataPass::SafeDownCast(pass))
  {
    return Find(data->GetDelegatePass(), asked);
  }
  if (auto* const steps = vtkRenderStepsPass::SafeDownCast(pass))
  {
    vtkRenderPass* const found = Find(steps->GetOpaquePass(), asked);
    return found ? found : Find(steps->GetPostProcessPass(), asked);
  }
  auto* const sequence = vtkSequencePass::SafeDownCast(pass);
  return sequence ? FindInSequence(sequence, asked) : nullptr;
}

bool IsFlat(vtkRenderPass* pass)
{
  return IsShadow(pass) || vtkImageProcessingPass::SafeDownCast(pass);
}
}

namespace wfv
{
vtkRenderPass* FindFlatPass(vtkRenderPass* pass)
{
  vtkRenderPass* const flat = Find(pass, IsFlat);
  if (flat)
  {
    WarnOnce(flat,
      IsShadow(flat) ? "its maps of shadows are looked up by a perspective"
                     : "inside of a vtkWideFoVPass it draws by a camera that is flat; set it on a "
                       "vtkWideFoVRenderer with the wide pass as its delegate");
  }
  return flat;
}

void PassChain::Link(vtkRenderPass* outer, vtkRenderPass* inner)
{
  if (!outer)
  {
    this->Outermost = inner;
  }
  else if (GetDelegate(outer) != inner)
  {
    this->Changes.push_back({ outer, GetDelegate(outer) });
    SetDelegate(outer, inner);
  }
}

vtkRenderPass* PassChain::Begin(vtkRenderPass* outermost, vtkWideFoVPass* wide)
{
  vtkRenderPass* kept = nullptr; // the innermost one so far
  vtkRenderPass* pass = outermost;
  while (pass && IsOverPicture(pass))
  {
    if (const char* const why = WhyLeftOut(pass))
    {
      WarnOnce(pass, why);
    }
    else
    {
      this->Link(kept, pass);
      kept = pass;
    }
    pass = GetDelegate(pass);
  }
  if (!Find(pass, MayBeWide))
  {
    this->Wide = wide;
    this->DelegateOfWide = wide->GetDelegatePass();
    wide->SetDelegatePass(pass);
    pass = wide;
  }
  this->Link(kept, pass);
  return this->Outermost;
}

PassChain::~PassChain()
{
  for (const Change& change : this->Changes)
  {
    SetDelegate(change.Pass, change.Delegate);
  }
  if (this->Wide)
  {
    this->Wide->SetDelegatePass(this->DelegateOfWide);
  }
}
}
