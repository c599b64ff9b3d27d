// SPDX-License-Identifier: BSD-3-Clause
// When the panel is there, and what is its own.
#include "Viewer.h"

#include <utility>

namespace widefov
{
void Viewer::TogglePanel()
{
  if (this->Shown)
  {
    this->Shown.reset();
    this->Places.clear();
    this->Changed();
    return;
  }
  this->Shown = this->Windows.MakePanel();
  if (!this->Shown)
  {
    this->Say(
      HasPanels() ? "this OpenGL draws no panel" : "this viewer was built without its panel");
    return;
  }
  this->Recently = this->Opened.Get();
  this->Unsettled = LayoutsToSettle;
  this->Changed();
}

// True where the panel shows all that followed from what happened.
bool Viewer::LayOut(bool happened)
{
  this->Unsettled = happened ? LayoutsToSettle : this->Unsettled;
  if (!this->Shown || this->Unsettled == 0)
  {
    return false;
  }
  this->Unsettled--;
  this->Shown->Layout([this] { this->Widgets(); });
  for (const Action action : std::exchange(this->Pressed, {}))
  {
    this->Message.clear();
    this->Do(action); // now, for it may take the panel away
  }
  return this->Shown && this->Unsettled == 0;
}

// By where the pointer was at the event, which the widgets may have heard of earlier or later.
// What was pressed elsewhere is let go elsewhere, wherever the pointer is.
bool Viewer::IsForPanel(const WindowEvent& event) const
{
  const std::array<double, 4>& area = this->PanelArea;
  const std::array<double, 2>& at = this->At.At;
  switch (this->Shown ? event.What : WindowEvent::Kind::Drop)
  {
    case WindowEvent::Kind::KeyPress:
    case WindowEvent::Kind::KeyRepeat:
      return this->Shown->WantsKeys();
    case WindowEvent::Kind::ButtonPress:
    case WindowEvent::Kind::Wheel:
      return this->HasPopup ||
        (this->At.Part == 0 && at[0] >= area[0] && at[1] >= area[1] && at[0] < area[2] &&
          at[1] < area[3]);
    default:
      return false;
  }
}
}
