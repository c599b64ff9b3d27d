// SPDX-License-Identifier: BSD-3-Clause
// The plugin as another version would be: its own number, WIDEFOV_OTHER_VERSION, and, of a later
// one, a property of the view that no process of today knows. What it draws with is today's.
#include "WideFoV_client_server.h"
#include "WideFoV_server_manager_modules.h"
#define PARAVIEW_BUILDING_PLUGIN // for the macro of the last line
#define PARAVIEW_PLUGIN_BUILT_SHARED 1
#include "vtkPVPlugin.h"
#include "vtkPVServerManagerPluginInterface.h"

namespace
{
constexpr char LaterProperty[] = R"(
      <IntVectorProperty name="Later" command="SetLater" number_of_elements="1" default_values="7" />
)";

class OtherVersion
  : public vtkPVPlugin
  , public vtkPVServerManagerPluginInterface
{
public:
  const char* GetPluginName() override { return "WideFoV"; }
  const char* GetPluginVersionString() override { return WIDEFOV_OTHER_VERSION; }
  bool GetRequiredOnServer() override { return true; }
  bool GetRequiredOnClient() override { return true; }
  const char* GetRequiredPlugins() override { return ""; }
  const char* GetDescription() override { return "Another version, for a test"; }
  const char* GetEULA() override { return nullptr; }
  void GetBinaryResources(std::vector<std::string>&) override {}

  void GetXMLs(std::vector<std::string>& xmls) override
  {
    WideFoV_server_manager_modules_initialize(xmls);
    const std::string before = "<StringVectorProperty name=\"Projection\"";
    for (std::string& xml : xmls)
    {
      const std::size_t place = xml.find(before);
      if (WIDEFOV_OTHER_IS_LATER && place != std::string::npos)
      {
        xml.insert(place, LaterProperty);
      }
    }
  }

  vtkClientServerInterpreterInitializer::InterpreterInitializationCallback
  GetInitializeInterpreterCallback() override
  {
    return WideFoV_client_server_initialize;
  }
};
}

PV_PLUGIN_EXPORT(WideFoV, OtherVersion)
