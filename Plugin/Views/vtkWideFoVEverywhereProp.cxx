// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWideFoVEverywhereProp.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkWideFoVEverywhereProp);

namespace
{
// Scene units: half the edge of the box, beyond all data; products of three of its
// coordinates are still finite in double.
constexpr double Everywhere = 1e60;
}

vtkWideFoVEverywhereProp::vtkWideFoVEverywhereProp()
{
  this->UseBoundsOff();
  this->PickableOff();
  for (int i = 0; i < 3; i++)
  {
    this->Bounds[2 * i] = -Everywhere;
    this->Bounds[2 * i + 1] = Everywhere;
  }
}

double* vtkWideFoVEverywhereProp::GetBounds()
{
  return this->Bounds;
}
