// SPDX-License-Identifier: BSD-3-Clause
// Whether client and server have the same version of this plugin.
#ifndef WideFoVPluginPluginVersions_h
#define WideFoVPluginPluginVersions_h

#include <string>

class vtkSMSession;

namespace wfvplugin
{
// One line where the server that this client is connected to has loaded another version of the
// plugin, of which ParaView itself takes no notice; empty where the versions are the same, or
// where client and server are one process.
std::string DescribeOtherVersion(vtkSMSession* session);
}

#endif
