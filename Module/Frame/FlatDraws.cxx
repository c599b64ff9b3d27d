// SPDX-License-Identifier: BSD-3-Clause
#include "Frame/FlatDraws.h"

#include "Drawables/PropFacts.h"
#include "Frame/PropParts.h"

#include "vtkActor.h"
#include "vtkActor2D.h"
#include "vtkMapper.h"
#include "vtkObject.h"

#include <algorithm>
#include <mutex>
#include <set>
#include <string>

namespace
{
using Keys = std::vector<const vtkInformation*>;

bool WasDrawn(vtkProp* prop, const Keys& drawn)
{
  return std::find(drawn.begin(), drawn.end(), prop->GetPropertyKeys()) != drawn.end();
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

std::set<std::string> NamesOf(const std::vector<vtkProp*>& props, const Keys& drawn)
{
  std::set<std::string> without;
  std::set<std::string> special;
  for (vtkProp* const prop : props)
  {
    auto* const actor = vtkActor::SafeDownCast(prop);
    if (vtkActor2D::SafeDownCast(prop))
    {
      continue;
    }
    if (!WasDrawn(prop, drawn) && !WasDrawnByParts(prop, drawn))
    {
      without.insert(NameOf(prop));
    }
    else if (!actor || !wfv::IsStockActor(actor))
    {
      special.insert(NameOf(prop));
    }
  }
  return without.empty() ? special : without;
}
}

namespace wfv
{
void WarnOfFlatDraws(vtkObject* reporter, const std::vector<vtkProp*>& props, const Keys& drawn)
{
  static std::mutex lock;
  static std::set<std::string> said;
  const std::lock_guard<std::mutex> guard(lock);
  std::string news;
  for (const std::string& name : NamesOf(props, drawn))
  {
    if (said.insert(name).second)
    {
      news += (news.empty() ? "" : ", ") + name;
    }
  }
  if (!news.empty())
  {
    vtkWarningWithObjectMacro(reporter,
      << "left out of a wide view, in whole or in part, for its shaders are its own: " << news);
  }
}
}
