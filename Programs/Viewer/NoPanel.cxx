// SPDX-License-Identifier: BSD-3-Clause
// What the viewer has instead of its panel where it is built without Dear ImGui.
#include "Panel.h"
#include "Viewer.h"

namespace widefov
{
bool HasPanels()
{
  return false;
}

std::unique_ptr<Panel> MakePanel(GLFWwindow*)
{
  return nullptr;
}

void Viewer::Widgets() {} // of no panel
}
