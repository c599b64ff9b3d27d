// SPDX-License-Identifier: BSD-3-Clause
// Pictures of a wide view as files: what the exporter and the extractor share.
#ifndef WideFoVPluginWidePicture_h
#define WideFoVPluginWidePicture_h

#include "vtkType.h"

#include <string>
#include <vector>

class vtkSMProxy;
class vtkSMViewProxy;

namespace wfvplugin
{
// Whether this is a view that the pictures are made of.
bool IsWideView(vtkSMProxy* view);

// Draws the view and writes it, as the properties Size, Eyes, Metadata and Quality of
// `settings` say; a vtkPVSession::ServerFlags says where: CLIENT or DATA_SERVER_ROOT. Returns
// the names of the files; none where that failed, which has been said in ParaView's log.
std::vector<std::string> WriteWidePictures(
  vtkSMViewProxy* view, vtkSMProxy* settings, const std::string& path, vtkTypeUInt32 location);
}

#endif
