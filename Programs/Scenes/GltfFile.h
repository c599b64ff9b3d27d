// SPDX-License-Identifier: BSD-3-Clause
// Files of glTF, with their materials and textures.
#ifndef WideFoVGltfFile_h
#define WideFoVGltfFile_h

#include "Scene.h"

#include <string>
#include <vector>

namespace widefov
{
// By its ending.
bool IsGltf(const std::string& path);

// One a part that has a material of its own, placed in the scene; none where VTK finds none. The
// file has been read once without complaint.
std::vector<SceneProp> ReadGltf(const std::string& path);
}

#endif
