// SPDX-License-Identifier: BSD-3-Clause
#include "BarPicture.h"

#include "Pictures/Frame.h"
#include "Pictures/ScalarBar.h"
#include "System/Display.h"
#include "Text/Messages.h"

#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

namespace widefov
{
namespace
{
// Pixels: twice those of the page, because screens may have two a pixel of a page.
constexpr std::array<int, 2> BarSize{ { 768, 128 } };
}

std::optional<Picture> DrawBar(const Scene& scene)
{
  const vtkSmartPointer<vtkScalarBarActor> bar = MakeScalarBar(scene);
  if (!bar)
  {
    return std::nullopt;
  }
  bar->SetPosition(0.03, 0.05);
  bar->SetWidth(0.94);
  bar->SetHeight(0.9);
  const DisplayConnection display;
  vtkNew<vtkRenderWindow> window;
  OpenWindow(window);
  window->SetSize(BarSize[0], BarSize[1]);
  const QuietStandardError quiet;
  vtkNew<vtkRenderer> renderer;
  renderer->AddViewProp(bar);
  window->AddRenderer(renderer);
  window->Render();
  CheckMessages();
  return ReadPicture(window);
}
}
