// SPDX-License-Identifier: BSD-3-Clause
#include "Wall.h"

namespace widefov
{
bool Wall::NextPreview()
{
  if (this->IsTiled())
  {
    return false;
  }
  const bool room = !this->Panes[0].Name.empty();
  const bool last = this->Preview && this->Preview->GetSight() != Sight::Seat;
  const Sight next = room ? Sight::Room : this->Preview ? Sight::Middle : Sight::Seat;
  this->Preview.reset();
  if (!last)
  {
    this->Preview = std::make_unique<PreviewWindow>(
      *this->Panes[0].Window, this->GetSize()[0], next, this->Panes.size());
  }
  return true;
}

void Wall::DrawPreview(const std::vector<Options>& parts)
{
  for (std::size_t i = 0; this->Preview && i < this->Panes.size(); i++)
  {
    if (this->Panes[i].Cost) // else nobody sees it
    {
      this->Preview->Set(i, parts[this->Panes[i].Part], this->Panes[i].Stage->GetFrame());
    }
  }
  this->RefreshPreview();
}

void Wall::RefreshPreview()
{
  if (this->Preview)
  {
    this->Preview->Refresh();
  }
}
}
