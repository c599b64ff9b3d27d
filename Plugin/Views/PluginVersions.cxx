// SPDX-License-Identifier: BSD-3-Clause
#include "PluginVersions.h"

#include "vtkNew.h"
#include "vtkPVPluginsInformation.h"
#include "vtkPVSession.h"
#include "vtkSMSession.h"

namespace wfvplugin
{
namespace
{
// Empty where the plugin is not loaded.
std::string VersionOf(vtkPVPluginsInformation* plugins)
{
  for (unsigned int i = 0; i < plugins->GetNumberOfPlugins(); i++)
  {
    if (plugins->GetPluginLoaded(i) && std::string(plugins->GetPluginName(i)) == "WideFoV")
    {
      return plugins->GetPluginVersion(i);
    }
  }
  return "";
}
}

std::string DescribeOtherVersion(vtkSMSession* session)
{
  if (!session || session->GetProcessRoles() != vtkPVSession::CLIENT)
  {
    return "";
  }
  vtkNew<vtkPVPluginsInformation> here;
  here->CopyFromObject(nullptr);
  const std::string ours = VersionOf(here);
  for (vtkTypeUInt32 server : { vtkPVSession::DATA_SERVER_ROOT, vtkPVSession::RENDER_SERVER_ROOT })
  {
    vtkNew<vtkPVPluginsInformation> there;
    session->GatherInformation(server, there, 0);
    const std::string theirs = VersionOf(there);
    if (!ours.empty() && !theirs.empty() && ours != theirs)
    {
      return "No Wide FoV View: the client has version " + ours +
        " of the plugin WideFoV, the server version " + theirs + ". Load the same version in both.";
    }
  }
  return "";
}
}
