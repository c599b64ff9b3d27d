// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMWideFoVViewProxy.h"

#include "PluginVersions.h"
#include "vtkWideFoVOverrides.h"

#include "vtkClientServerStream.h"
#include "vtkObjectFactory.h"
#include "vtkRenderWindow.h"
#include "vtkSMProxyManager.h"
#include "vtkSMSession.h"

#include <string>

// Not the standard macro: ParaView would take the server's properties, tell them to a view of the
// client that may not know them, and crash. Without a proxy there is no view, as where one of the
// two lacks the plugin.
vtkSMWideFoVViewProxy* vtkSMWideFoVViewProxy::New()
{
  // which ParaView gives the proxy later only
  vtkSMSession* const session = vtkSMProxyManager::GetProxyManager()->GetActiveSession();
  const std::string line = wfvplugin::DescribeOtherVersion(session);
  if (!line.empty())
  {
    vtkErrorWithObjectMacro(session, << line);
    return nullptr;
  }
  VTK_STANDARD_NEW_BODY(vtkSMWideFoVViewProxy);
}

void vtkSMWideFoVViewProxy::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

void vtkSMWideFoVViewProxy::CreateVTKObjects()
{
  vtkWideFoVOverrides wide; // for the proxy of the camera, which says "vtkCamera"
  this->Superclass::CreateVTKObjects();
}

vtkImageData* vtkSMWideFoVViewProxy::CaptureWindowInternal(int magX, int magY)
{
  vtkImageData* const picture = this->Superclass::CaptureWindowInternal(magX, magY);
  vtkRenderWindow* const window = this->GetRenderWindow();
  if (window && (magX > 1 || magY > 1))
  {
    // ParaView tells them of tiles before a still frame alone, and a flat camera does not ask:
    // until the next one a selection, or a frame that moves, would be of the last tile
    const int* const scale = window->GetTileScale();
    const double* const part = window->GetTileViewport();
    vtkClientServerStream stream;
    stream << vtkClientServerStream::Invoke << VTKOBJECT(this) << "SetTileScale" << scale[0]
           << scale[1] << vtkClientServerStream::End << vtkClientServerStream::Invoke
           << VTKOBJECT(this) << "SetTileViewport" << part[0] << part[1] << part[2] << part[3]
           << vtkClientServerStream::End;
    this->ExecuteStream(stream);
  }
  return picture;
}
