// SPDX-License-Identifier: BSD-3-Clause
// Direction maps as files: what the projection "direction-map" shows.
#ifndef WideFoVPluginDirectionFile_h
#define WideFoVPluginDirectionFile_h

#include <memory>
#include <string>

namespace wfv
{
class DirectionMap;
}

namespace wfvplugin
{
// The map in an OpenEXR image with the channels X, Y, Z, or R, G, B: x to the right, y up, z
// behind. Throws std::runtime_error that says what is wrong with the file.
std::shared_ptr<const wfv::DirectionMap> ReadDirectionFile(const std::string& path);
}

#endif
