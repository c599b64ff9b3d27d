// SPDX-License-Identifier: BSD-3-Clause
// The C++ lines of the README, then a look at what they drew.
#include "vtkActor.h"
#include "vtkConeSource.h"
#include "vtkNew.h"
#include "vtkPolyDataMapper.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkUnsignedCharArray.h"
#include "vtkWideFoVCamera.h"
#include "vtkWideFoVPass.h"

#include <iostream>

namespace
{
// The cone seen from two of its radii away is some 55 by 45 degrees of 360 by 180, half
// of that rectangle filled: 2 %. Outside these bounds it is not the cone.
constexpr double LeastCovered = 0.005;
constexpr double MostCovered = 0.1;

bool IsDrawn(vtkUnsignedCharArray* pixels, int pixel)
{
  const unsigned char* rgb = pixels->GetPointer(3 * pixel);
  return rgb[0] + rgb[1] + rgb[2] > 0;
}

// 0 where the picture shows the cone ahead and nothing behind.
int Check(vtkRenderWindow* window)
{
  const int* size = window->GetSize();
  vtkNew<vtkUnsignedCharArray> pixels;
  window->GetPixelData(0, 0, size[0] - 1, size[1] - 1, 0, pixels);
  int drawn = 0;
  for (int i = 0; i < size[0] * size[1]; i++)
  {
    drawn += IsDrawn(pixels, i) ? 1 : 0;
  }
  const double covered = double(drawn) / (size[0] * size[1]);
  const int row = size[1] / 2 * size[0];
  const bool ahead = IsDrawn(pixels, row + size[0] / 2);
  const bool behind = IsDrawn(pixels, row);
  std::cout << size[0] << " x " << size[1] << " pixels, covered " << covered << " (" << LeastCovered
            << " to " << MostCovered << "), ahead " << ahead << " (1), behind " << behind
            << " (0)\n";
  return covered > LeastCovered && covered < MostCovered && ahead && !behind ? 0 : 1;
}
}

int main()
{
#include README_CXX
  return Check(window);
}
