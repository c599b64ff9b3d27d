// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMWideFoVViewProxy.h"

#include "PluginVersions.h"
#include "vtkWideFoVOverrides.h"

#include "vtkObjectFactory.h"
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
