// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWideFoVCellPicker.h"

#include "Camera/FlatQuestions.h"
#include "vtkWideFoVCamera.h"
#include "vtkWideFoVRenderer.h"

#include "vtkCommand.h"
#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkWideFoVCellPicker);

void vtkWideFoVCellPicker::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

int vtkWideFoVCellPicker::Pick(double x, double y, double z, vtkRenderer* renderer)
{
  auto* wide = vtkWideFoVRenderer::SafeDownCast(renderer);
  auto* camera = wide ? vtkWideFoVCamera::SafeDownCast(wide->GetActiveCamera()) : nullptr;
  if (!camera || !camera->IsWide())
  {
    return this->Superclass::Pick(x, y, z, renderer);
  }
  this->Initialize();
  this->Renderer = renderer;
  this->SelectionPoint[0] = x;
  this->SelectionPoint[1] = y;
  this->SelectionPoint[2] = z;
  this->InvokeEvent(vtkCommand::StartPickEvent, nullptr);
  int result = 0;
  double origin[3];
  double direction[3];
  if (wide->DisplayToRay(x, y, origin, direction))
  {
    double from[4] = { 0, 0, 0, 1 };
    double to[4] = { 0, 0, 0, 1 };
    for (int i = 0; i < 3; i++)
    {
      from[i] = origin[i] + camera->GetNearClipRadius() * direction[i];
      to[i] = origin[i] + camera->GetFarClipRadius() * direction[i];
      this->PickPosition[i] = to[i];
    }
    camera->GetFlatQuestions().ExpectMiddle();
    result = this->Pick3DInternal(renderer, from, to);
  }
  this->InvokeEvent(vtkCommand::EndPickEvent, nullptr);
  return result;
}
