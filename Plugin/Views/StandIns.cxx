// SPDX-License-Identifier: BSD-3-Clause
#include "StandIns.h"

#include "AxesGrid.h"
#include "PolarAxes.h"
#include "vtkWideFoVCamera.h"

#include "vtkPolarAxesActor.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"

#include <algorithm>

namespace wfvplugin
{
namespace
{
bool NeedsOne(vtkProp* prop)
{
  return GridAxesActor::SafeDownCast(prop) || prop->IsA("vtkPolarAxesActor");
}

std::unique_ptr<StandIn> Make(vtkProp* prop)
{
  if (auto* const grid = GridAxesActor::SafeDownCast(prop))
  {
    return std::make_unique<AxesGrid>(grid);
  }
  return std::make_unique<PolarAxes>(vtkPolarAxesActor::SafeDownCast(prop));
}

std::vector<vtkProp*> ListStock(vtkRenderer* renderer)
{
  std::vector<vtkProp*> found;
  vtkPropCollection* const props = renderer->GetViewProps();
  vtkCollectionSimpleIterator it;
  props->InitTraversal(it);
  while (vtkProp* const prop = props->GetNextProp(it))
  {
    if (NeedsOne(prop))
    {
      found.push_back(prop);
    }
  }
  return found;
}
}

StandIns::StandIns() = default;
StandIns::~StandIns() = default;

void StandIns::Begin(vtkRenderer* renderer)
{
  const std::vector<vtkProp*> stock = ListStock(renderer);
  const auto gone = [&](const StandIn* one) {
    return std::find(stock.begin(), stock.end(), one->GetStock()) == stock.end();
  };
  // of a frame that was broken off
  this->Shown.erase(
    std::remove_if(this->Shown.begin(), this->Shown.end(), gone), this->Shown.end());
  this->End();
  const auto unused = [&](const std::unique_ptr<StandIn>& one) { return gone(one.get()); };
  this->All.erase(std::remove_if(this->All.begin(), this->All.end(), unused), this->All.end());
  auto* const camera = vtkWideFoVCamera::SafeDownCast(renderer->GetActiveCamera());
  if (!camera || !camera->IsWide())
  {
    return;
  }
  for (vtkProp* const prop : stock)
  {
    if (!prop->GetVisibility())
    {
      continue;
    }
    const auto same = [&](const std::unique_ptr<StandIn>& one) { return one->GetStock() == prop; };
    auto it = std::find_if(this->All.begin(), this->All.end(), same);
    if (it == this->All.end())
    {
      it = this->All.insert(it, Make(prop));
    }
    (*it)->Show(renderer);
    this->Shown.push_back(it->get());
  }
}

void StandIns::End()
{
  for (StandIn* const one : this->Shown)
  {
    one->Hide();
  }
  this->Shown.clear();
}
}
