// SPDX-License-Identifier: BSD-3-Clause
#include "PluginVersions.h"

#include "vtkNew.h"
#include "vtkPVPluginsInformation.h"
#include "vtkPVSession.h"
#include "vtkPVWideFoVVersion.h"
#include "vtkSMSession.h"

namespace wfvplugin
{
namespace
{
bool HasPlugin(vtkSMSession* session, vtkTypeUInt32 server)
{
  vtkNew<vtkPVPluginsInformation> plugins;
  session->GatherInformation(server, plugins, 0);
  for (unsigned int i = 0; i < plugins->GetNumberOfPlugins(); i++)
  {
    if (plugins->GetPluginLoaded(i) && std::string(plugins->GetPluginName(i)) == "WideFoV")
    {
      return true;
    }
  }
  return false;
}
}

std::string DescribeOtherVersion(vtkSMSession* session)
{
  if (!session || session->GetProcessRoles() != vtkPVSession::CLIENT)
  {
    return "";
  }
  vtkNew<vtkPVWideFoVVersion> here;
  here->CopyFromObject(nullptr);
  const std::string& ours = here->GetVersion();
  for (vtkTypeUInt32 server : { vtkPVSession::DATA_SERVER_ROOT, vtkPVSession::RENDER_SERVER_ROOT })
  {
    if (!HasPlugin(session, server))
    {
      continue; // ParaView says so
    }
    vtkNew<vtkPVWideFoVVersion> there;
    session->GatherInformation(server, there, 0);
    const std::string& theirs = there->GetVersion();
    if (ours != theirs)
    {
      return "No Wide FoV View: the client has version " + ours +
        " of the plugin WideFoV, the server version " + theirs + ". Load the same version in both.";
    }
  }
  return "";
}
}
