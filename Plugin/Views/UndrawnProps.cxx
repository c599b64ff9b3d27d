// SPDX-License-Identifier: BSD-3-Clause
#include "UndrawnProps.h"

#include "vtkProp.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"

namespace wfvplugin
{
namespace
{
struct Kind
{
  const char* ClassName;
  const char* Line;
};

const Kind Kinds[] = {
  { "vtkCubeAxesActor",
    "Cube axes cannot be drawn right in this view yet: they place their lines and labels for a "
    "flat "
    "picture. Show an Outline, a Ruler or Billboard 3D Text instead." },
};

bool IsShown(vtkRenderer* renderer, const char* className)
{
  vtkPropCollection* const props = renderer->GetViewProps();
  vtkCollectionSimpleIterator it;
  props->InitTraversal(it);
  while (vtkProp* const prop = props->GetNextProp(it))
  {
    if (prop->GetVisibility() && prop->IsA(className))
    {
      return true;
    }
  }
  return false;
}
}

std::vector<std::string> UndrawnProps::Look(vtkRenderer* renderer)
{
  std::vector<std::string> lines;
  std::vector<bool> shown;
  for (const Kind& kind : Kinds)
  {
    shown.push_back(IsShown(renderer, kind.ClassName));
    if (shown.back() && (this->Said.size() < shown.size() || !this->Said[shown.size() - 1]))
    {
      lines.emplace_back(kind.Line);
    }
  }
  this->Said = shown; // said again when one is shown anew
  return lines;
}
}
