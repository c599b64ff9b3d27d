// SPDX-License-Identifier: BSD-3-Clause
#include "Frame/FlatDraws.h"

#include "Compat/Reports.h"
#include "Drawables/Kinds/DrawableKinds.h"
#include "Drawables/Sky.h"
#include "Frame/PropParts.h"

#include "vtkActor.h"
#include "vtkActor2D.h"
#include "vtkFollower.h"
#include "vtkMapper.h"
#include "vtkObject.h"
#include "vtkVolume.h"

#include <algorithm>
#include <set>
#include <string>

namespace
{
using Keys = std::vector<const vtkInformation*>;

bool WasDrawn(vtkProp* prop, const Keys& drawn)
{
  return std::binary_search(drawn.begin(), drawn.end(), prop->GetPropertyKeys());
}

bool WasDrawnByParts(vtkProp* prop, const Keys& drawn)
{
  const auto parts = wfv::FindParts(prop);
  return std::any_of(
    parts.begin(), parts.end(), [&drawn](vtkProp* part) { return WasDrawn(part, drawn); });
}

std::string NameOf(vtkProp* prop)
{
  auto* const actor = vtkActor::SafeDownCast(prop);
  vtkMapper* const mapper = actor ? actor->GetMapper() : nullptr;
  const std::string name = prop->GetClassName();
  return mapper ? name + " with a " + mapper->GetClassName() : name;
}

// What may be drawn whole without shaders of its own.
bool IsWhole(vtkProp* prop)
{
  auto* const actor = vtkActor::SafeDownCast(prop);
  return (actor && wfv::IsStockActor(actor)) || vtkFollower::SafeDownCast(prop) ||
    vtkVolume::SafeDownCast(prop) || wfv::sky::Is(prop);
}

// drawn: in order
std::set<std::string> NamesOf(const std::vector<vtkProp*>& props, const Keys& drawn)
{
  std::set<std::string> without;
  std::set<std::string> special;
  for (vtkProp* const prop : props)
  {
    if (vtkActor2D::SafeDownCast(prop))
    {
      continue;
    }
    if (!WasDrawn(prop, drawn) && !WasDrawnByParts(prop, drawn))
    {
      without.insert(NameOf(prop));
    }
    else if (!IsWhole(prop))
    {
      special.insert(NameOf(prop));
    }
  }
  return without.empty() ? special : without;
}
}

namespace wfv
{
void WarnOfFlatDraws(vtkObject* reporter, const std::vector<vtkProp*>& props, Keys drawn)
{
  std::sort(drawn.begin(), drawn.end());
  std::string news;
  for (const std::string& name : NamesOf(props, drawn))
  {
    if (wfv::IsNews("own shaders " + name))
    {
      news += (news.empty() ? "" : ", ") + name;
    }
  }
  if (!news.empty())
  {
    vtkWarningWithObjectMacro(reporter,
      << "left out of a wide view, in whole or in part, for it has shaders of its own, or parts "
         "that were made before this library was loaded: "
      << news);
  }
}
}
