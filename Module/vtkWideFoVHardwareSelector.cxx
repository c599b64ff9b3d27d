// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWideFoVHardwareSelector.h"

#include "vtkObjectFactory.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

vtkStandardNewMacro(vtkWideFoVHardwareSelector);

bool vtkWideFoVHardwareSelector::CaptureBuffers()
{
  vtkRenderWindow* const window = this->Renderer ? this->Renderer->GetRenderWindow() : nullptr;
  if (!window || !window->GetStereoRender())
  {
    return this->Superclass::CaptureBuffers();
  }
  const int type = window->GetStereoType();
  window->SetStereoType(VTK_STEREO_LEFT);
  const bool captured = this->Superclass::CaptureBuffers();
  window->SetStereoType(type);
  return captured;
}

void vtkWideFoVHardwareSelector::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
