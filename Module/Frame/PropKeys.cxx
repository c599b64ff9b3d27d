// SPDX-License-Identifier: BSD-3-Clause
#include "Frame/PropKeys.h"

#include "Drawables/Kinds/DrawableKinds.h"
#include "Frame/vtkWideFoVStage.h"

#include "vtkActor2D.h"
#include "vtkInformationObjectBaseVectorKey.h"
#include "vtkProp.h"

namespace
{
// Its setter says that the prop was modified.
class PropAccess : public vtkProp
{
public:
  static vtkInformation*& Keys(vtkProp* prop) { return prop->*(&PropAccess::PropertyKeys); }
};

}

namespace wfv
{
void HandPassesOn(vtkInformation* from, vtkInformation* to)
{
  vtkInformationObjectBaseVectorKey* const list = vtkOpenGLRenderPass::RenderPasses();
  to->Remove(list);
  for (int i = 0; from && i < from->Length(list); i++)
  {
    vtkObjectBase* const pass = from->Get(list, i);
    if (!vtkWideFoVStage::SafeDownCast(pass))
    {
      to->Append(list, pass);
    }
  }
}

void PropKeys::Attach(vtkProp* prop, vtkWideFoVStage* stage)
{
  vtkInformationObjectBaseVectorKey* const list = vtkOpenGLRenderPass::RenderPasses();
  if (vtkActor2D::SafeDownCast(prop))
  {
    return;
  }
  if (prop->GetPropertyKeys() || !HasTrait(prop, StockActor))
  {
    if (!prop->GetPropertyKeys())
    {
      prop->SetPropertyKeys(vtkSmartPointer<vtkInformation>::New());
    }
    prop->GetPropertyKeys()->Append(list, stage);
    return;
  }
  if (!this->Lent)
  {
    this->Lent = this->OfProp = vtkSmartPointer<vtkInformation>::New();
  }
  const bool same = this->Lent->Length(list) == 1 && this->Lent->Get(list, 0) == stage;
  if (!same)
  {
    this->Lent->Clear();
    this->Lent->Append(list, stage);
  }
  // not registered anew each time: to take that back would start VTK's collection of garbage
  PropAccess::Keys(prop) = this->OfProp;
  this->Lends = true;
}

void PropKeys::Detach(vtkProp* prop, vtkWideFoVStage* stage)
{
  vtkInformationObjectBaseVectorKey* const list = vtkOpenGLRenderPass::RenderPasses();
  vtkInformation* const info = prop->GetPropertyKeys();
  const bool lends = this->Lends;
  this->Lends = false;
  if (lends && info == this->OfProp)
  {
    PropAccess::Keys(prop) = nullptr;
    return;
  }
  if (lends)
  {
    this->OfProp->Register(nullptr); // for the one that the prop gave up for other keys
  }
  if (!info || !info->Has(list))
  {
    return;
  }
  info->Remove(list, stage);
  if (info->Length(list) == 0)
  {
    info->Remove(list);
  }
}
}
