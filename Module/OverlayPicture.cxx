// SPDX-License-Identifier: BSD-3-Clause
#include "OverlayPicture.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkProp.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace
{
using Color = std::array<float, 4>; // red, green and blue times what is covered, and that; 0 to 255

struct Pixels
{
  int Width;
  int Height;
  std::vector<Color> Values;

  // Beyond a border is the other side.
  const Color& At(int x, int y) const
  {
    const int column = (x + this->Width) % this->Width;
    const int row = (y + this->Height) % this->Height;
    return this->Values[static_cast<std::size_t>(row) * this->Width + column];
  }
};

void Add(Color& sum, const Color& c)
{
  for (int k = 0; k < 4; k++)
  {
    sum[k] += c[k];
  }
}

// Gives what is clear the colours that are so many pixels away.
Pixels Spread(const Pixels& from, int step)
{
  Pixels to = from;
  for (int y = 0; y < from.Height; y++)
  {
    for (int x = 0; x < from.Width; x++)
    {
      Color& c = to.Values[static_cast<std::size_t>(y) * from.Width + x];
      if (c[3] > 0)
      {
        continue;
      }
      Add(c, from.At(x + step % from.Width, y));
      Add(c, from.At(x - step % from.Width, y));
      Add(c, from.At(x, y + step % from.Height));
      Add(c, from.At(x, y - step % from.Height));
    }
  }
  return to;
}

Pixels Draw(vtkProp* overlay, int width, int height)
{
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(0);
  window->SetAlphaBitPlanes(1);
  window->SetSize(width, height);
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackgroundAlpha(0);
  renderer->AddViewProp(overlay);
  window->AddRenderer(renderer);
  window->Render();
  vtkNew<vtkUnsignedCharArray> bytes;
  window->GetRGBACharPixelData(0, 0, width - 1, height - 1, 0, bytes);
  overlay->ReleaseGraphicsResources(window);
  renderer->RemoveAllViewProps();
  window->Finalize();
  Pixels pixels{ width, height, std::vector<Color>(static_cast<std::size_t>(width) * height) };
  const unsigned char* byte = bytes->GetPointer(0);
  for (Color& c : pixels.Values)
  {
    std::copy_n(byte, 4, c.begin());
    byte += 4;
  }
  return pixels;
}
}

namespace wfv
{
vtkSmartPointer<vtkImageData> MakeOverlayPicture(vtkProp* overlay, int width, int height)
{
  const Pixels drawn = Draw(overlay, width, height);
  Pixels filled = drawn;
  for (int step = 1; step < std::max(width, height); step *= 2)
  {
    filled = Spread(filled, step);
  }
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(width, height, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  auto* byte = static_cast<unsigned char*>(image->GetScalarPointer());
  for (std::size_t i = 0; i < drawn.Values.size(); i++)
  {
    const Color& c = filled.Values[i];
    for (int k = 0; k < 3; k++)
    {
      const float whole = c[3] > 0 ? c[k] * 255 / c[3] : c[k];
      *byte++ = static_cast<unsigned char>(std::lround(std::min(whole, 255.f)));
    }
    *byte++ = static_cast<unsigned char>(drawn.Values[i][3]);
  }
  return image;
}
}
