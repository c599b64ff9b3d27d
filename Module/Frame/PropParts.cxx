// SPDX-License-Identifier: BSD-3-Clause
#include "Frame/PropParts.h"

#include "Compat/ImageModule.h"
#include "Frame/PartActor.h"
#include "Frame/Stages.h"

#include "vtkActor.h"
#include "vtkActor2D.h"
#include "vtkAssemblyNode.h"
#include "vtkAssemblyPath.h"
#include "vtkBillboardTextActor3D.h"
#include "vtkNew.h"
#include "vtkPropCollection.h"
#include "vtkVolume.h"

#include <algorithm>

namespace
{
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

PropList PropParts::Attach(vtkProp* prop, Stages& stages)
{
  PropList parts = FindParts(prop);
  for (const vtkSmartPointer<vtkProp>& part : parts)
  {
    if (FindsItsFrame(part) || vtkActor2D::SafeDownCast(part) || stages.FindAttached(part))
    {
      continue;
    }
    PropFacts facts;
    vtkWideFoVStage* const stage = stages.Choose(part, part->GetBounds(), facts);
    this->Parts.push_back({ part, stage, {} });
    this->Parts.back().Keys.Attach(part, stage);
  }
  return parts;
}

void PropParts::Detach()
{
  for (Part& part : this->Parts)
  {
    part.Keys.Detach(part.Prop, part.Stage);
  }
  this->Parts.clear();
}
}
