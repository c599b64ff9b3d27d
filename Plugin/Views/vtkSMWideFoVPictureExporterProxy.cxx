// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMWideFoVPictureExporterProxy.h"

#include "WidePicture.h"

#include "vtkObjectFactory.h"
#include "vtkPVSession.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMViewProxy.h"

vtkStandardNewMacro(vtkSMWideFoVPictureExporterProxy);

void vtkSMWideFoVPictureExporterProxy::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

bool vtkSMWideFoVPictureExporterProxy::CanExport(vtkSMProxy* view)
{
  return wfvplugin::IsWideView(view);
}

void vtkSMWideFoVPictureExporterProxy::Write()
{
  if (this->View)
  {
    const std::string path = vtkSMPropertyHelper(this, "FileName").GetAsString();
    wfvplugin::WriteWidePictures(this->View, this, path, vtkPVSession::CLIENT);
  }
}
