// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMWideFoVViewProxy.h"

#include "vtkWideFoVOverrides.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkSMWideFoVViewProxy);

void vtkSMWideFoVViewProxy::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

void vtkSMWideFoVViewProxy::CreateVTKObjects()
{
  vtkWideFoVOverrides wide; // for the proxy of the camera, which says "vtkCamera"
  this->Superclass::CreateVTKObjects();
}
