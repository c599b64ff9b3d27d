// SPDX-License-Identifier: BSD-3-Clause
#include "AxesGrids.h"

#include "AxesGrid.h"
#include "vtkWideFoVCamera.h"

#include "vtkGridAxes3DActor.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"

#include <algorithm>

namespace wfvplugin
{
namespace
{
std::vector<vtkGridAxes3DActor*> ListGrids(vtkRenderer* renderer)
{
  std::vector<vtkGridAxes3DActor*> found;
  vtkPropCollection* const props = renderer->GetViewProps();
  vtkCollectionSimpleIterator it;
  props->InitTraversal(it);
  while (vtkProp* const prop = props->GetNextProp(it))
  {
    if (auto* const grid = vtkGridAxes3DActor::SafeDownCast(prop))
    {
      found.push_back(grid);
    }
  }
  return found;
}
}

AxesGrids::AxesGrids() = default;
AxesGrids::~AxesGrids() = default;

void AxesGrids::Begin(vtkRenderer* renderer)
{
  const std::vector<vtkGridAxes3DActor*> stock = ListGrids(renderer);
  const auto gone = [&](const AxesGrid* grid) {
    return std::find(stock.begin(), stock.end(), grid->GetStock()) == stock.end();
  };
  // of a frame that was broken off
  this->Shown.erase(
    std::remove_if(this->Shown.begin(), this->Shown.end(), gone), this->Shown.end());
  this->End();
  const auto unused = [&](const std::unique_ptr<AxesGrid>& grid) { return gone(grid.get()); };
  this->Grids.erase(
    std::remove_if(this->Grids.begin(), this->Grids.end(), unused), this->Grids.end());
  auto* const camera = vtkWideFoVCamera::SafeDownCast(renderer->GetActiveCamera());
  if (!camera || !camera->IsWide())
  {
    return;
  }
  for (vtkGridAxes3DActor* const actor : stock)
  {
    if (!actor->GetVisibility())
    {
      continue;
    }
    const auto same = [&](const std::unique_ptr<AxesGrid>& g) { return g->GetStock() == actor; };
    auto it = std::find_if(this->Grids.begin(), this->Grids.end(), same);
    if (it == this->Grids.end())
    {
      it = this->Grids.insert(it, std::make_unique<AxesGrid>(actor));
    }
    (*it)->Show(renderer);
    this->Shown.push_back(it->get());
  }
}

void AxesGrids::End()
{
  for (AxesGrid* const grid : this->Shown)
  {
    grid->Hide();
  }
  this->Shown.clear();
}
}
