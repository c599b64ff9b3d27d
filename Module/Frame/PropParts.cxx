// SPDX-License-Identifier: BSD-3-Clause
#include "Frame/PropParts.h"

#include "Camera/PropBounds.h"
#include "Compat/ImageModule.h"
#include "Drawables/PropTraits.h"
#include "Drawables/Sky.h"
#include "Frame/PartActor.h"
#include "Frame/Stages.h"

#include "vtkActor.h"
#include "vtkActor2D.h"
#include "vtkAssemblyNode.h"
#include "vtkAssemblyPath.h"
#include "vtkBillboardTextActor3D.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseVectorKey.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderPass.h"
#include "vtkPropCollection.h"
#include "vtkVolume.h"

#include <algorithm>

namespace
{
// Its setter says that the prop was modified.
class VisibilityAccess : public vtkProp
{
public:
  static auto& Of(vtkProp* prop) { return prop->*(&VisibilityAccess::Visibility); }
};

using PropList = std::vector<vtkSmartPointer<vtkProp>>;

// Actors are what they are; overlays have no place in the scene; and to ask a text of no letters
// for its actor ends the program.
bool IsOne(vtkProp* prop)
{
  return vtkActor::SafeDownCast(prop) || vtkVolume::SafeDownCast(prop) ||
    vtkActor2D::SafeDownCast(prop) || vtkBillboardTextActor3D::SafeDownCast(prop);
}

// Collections of actors hold props of any kind, whatever they are called.
void Add(vtkPropCollection* props, vtkProp* whole, PropList& parts)
{
  vtkCollectionSimpleIterator it;
  props->InitTraversal(it);
  while (auto* const part = vtkProp::SafeDownCast(props->GetNextItemAsObject(it)))
  {
    if (part != whole && std::find(parts.begin(), parts.end(), part) == parts.end())
    {
      parts.emplace_back(part);
    }
  }
}

// Some are named by paths alone.
void AddOfPaths(vtkProp* prop, vtkPropCollection* props)
{
  prop->InitPathTraversal();
  while (vtkAssemblyPath* const path = prop->GetNextPath())
  {
    vtkAssemblyNode* const last = path->GetLastNode();
    if (last && last->GetViewProp())
    {
      props->AddItem(last->GetViewProp());
    }
  }
}
}

namespace wfv
{
PropList FindParts(vtkProp* prop)
{
  PropList parts;
  if (vtkActor* const drawer = sky::PrepareDrawer(prop))
  {
    parts.emplace_back(drawer);
    return parts;
  }
  if (IsOne(prop))
  {
    return parts;
  }
  vtkNew<vtkPropCollection> props;
  prop->GetActors(props);
  prop->GetVolumes(props);
  AddOfPaths(prop, props);
  AddImagesOfStack(prop, props);
  Add(props, prop, parts);
  return parts;
}

void PropParts::Attach(vtkProp* part, vtkWideFoVStage* stage)
{
  this->Parts.push_back({ part, stage, {} });
  this->Parts.back().Keys.Attach(part, stage);
}

void PropParts::AttachSky(vtkProp* prop, Stages& stages)
{
  vtkActor* const drawer = sky::PrepareDrawer(prop);
  if (drawer && !Stages::FindAttached(drawer))
  {
    // a sky keeps its keys to itself
    HandPassesOn(prop->GetPropertyKeys(), drawer->GetPropertyKeys());
    this->Attach(drawer, stages.Sky);
  }
}

PropList PropParts::Attach(vtkProp* prop, Stages& stages, bool selects)
{
  PropList parts = FindParts(prop);
  if (sky::Is(prop))
  {
    this->AttachSky(prop, stages);
    return parts;
  }
  for (const vtkSmartPointer<vtkProp>& part : parts)
  {
    PropTraits traits;
    if (sky::IsLeftOut(part, selects) || stages.IsLeftOut(part, traits))
    {
      this->LeaveOut(part);
    }
    else if (sky::Is(part))
    {
      this->AttachSky(part, stages);
    }
    else if (!FindsItsFrame(part) && !vtkActor2D::SafeDownCast(part) && !Stages::FindAttached(part))
    {
      double bounds[6];
      this->Attach(part, stages.Choose(part, FindBounds(part, bounds) ? bounds : nullptr, traits));
    }
  }
  return parts;
}

void PropParts::LeaveOut(vtkProp* part)
{
  if (part->GetVisibility())
  {
    VisibilityAccess::Of(part) = 0;
    this->LeftOut.emplace_back(part);
  }
}

void PropParts::Detach()
{
  for (Part& part : this->Parts)
  {
    part.Keys.Detach(part.Prop, part.Stage);
  }
  this->Parts.clear();
  for (vtkProp* const part : this->LeftOut)
  {
    VisibilityAccess::Of(part) = 1;
  }
  this->LeftOut.clear();
}
}
