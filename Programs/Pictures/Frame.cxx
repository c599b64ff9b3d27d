// SPDX-License-Identifier: BSD-3-Clause
#include "Frame.h"

#include "System/MessageCatcher.h"
#include "Text/Messages.h"

#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>
#include <vtkWideFoVPass.h>
#include <vtkWideFoVStatisticsActor.h>

#include <algorithm>

namespace widefov
{
vtkSmartPointer<vtkProp> AddOverlay(
  vtkRenderer* renderer, vtkWideFoVPass* pass, const Options& o, bool tiles)
{
  if (o.Overlay && tiles)
  {
    Say("warning: --overlay is not for pictures in tiles; it is left out");
  }
  if (!o.Overlay || tiles)
  {
    return nullptr;
  }
  vtkNew<vtkWideFoVStatisticsActor> overlay;
  overlay->SetPass(pass);
  renderer->AddViewProp(overlay);
  return overlay.Get();
}

void CheckSize(const Options& o, const GlLimits& limits)
{
  if (o.Size[0] > limits.Width || o.Size[1] > limits.Height)
  {
    Fail("--size " + std::to_string(o.Size[0]) + "x" + std::to_string(o.Size[1]) +
      " is over the limit of this OpenGL, " + std::to_string(limits.Width) + "x" +
      std::to_string(limits.Height) + " pixels; choose a smaller size");
  }
  if (o.Technique == Technique::CubeMap && o.CubeMapResolution > limits.Width)
  {
    Fail("--cubemap-resolution " + std::to_string(o.CubeMapResolution) +
      " is over the limit of this OpenGL, " + std::to_string(limits.Width) +
      " pixels; choose a smaller one");
  }
}

int UsableSamples(int samples, const GlLimits& limits)
{
  if (samples > limits.Samples)
  {
    Say("warning: --samples " + std::to_string(samples) + " is over the limit of this OpenGL; " +
      std::to_string(limits.Samples) + " are used");
    samples = limits.Samples;
  }
  return samples > 1 ? samples : 0;
}

void CheckMessages()
{
  const std::string error = MessageCatcher::TakeFirstError();
  if (!error.empty())
  {
    Fail("drawing failed: " + error + "; update the graphics driver, or report it");
  }
  for (const std::string& warning : MessageCatcher::TakeWarnings())
  {
    Say("warning: " + warning);
  }
}

Picture ReadPicture(vtkRenderWindow* window)
{
  Picture picture;
  const int* const size = window->GetActualSize(); // of a tile, not of the whole
  picture.Width = size[0];
  picture.Height = size[1];
  vtkNew<vtkUnsignedCharArray> pixels;
  window->GetPixelData(0, 0, size[0] - 1, size[1] - 1, 0, pixels);
  const std::size_t row = 3 * static_cast<std::size_t>(picture.Width);
  picture.Rgb.resize(row * picture.Height);
  for (int j = 0; j < picture.Height; j++)
  {
    const unsigned char* const from =
      pixels->GetPointer(static_cast<vtkIdType>(row) * (picture.Height - 1 - j));
    std::copy(from, from + row, picture.Rgb.begin() + static_cast<std::ptrdiff_t>(row * j));
  }
  return picture;
}
}
