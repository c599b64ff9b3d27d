// SPDX-License-Identifier: BSD-3-Clause
#include "StereoWindow.h"

#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkWideFoVStereoWindow.h>

namespace widefov
{
void SetAnaglyph(vtkRenderWindow* window, const Options& o)
{
  window->SetAnaglyphColorMask(o.AnaglyphMask[0], o.AnaglyphMask[1]);
  window->SetAnaglyphColorSaturation(static_cast<float>(o.AnaglyphSaturation));
}

void AddStereoWindow(vtkRenderer* renderer, const Options& o)
{
  if (o.FloatingWindow > 0 || o.Letterbox > 0)
  {
    vtkNew<vtkWideFoVStereoWindow> window;
    window->SetFloating(o.FloatingWindow);
    window->SetLetterbox(o.Letterbox);
    renderer->AddViewProp(window);
  }
}
}
