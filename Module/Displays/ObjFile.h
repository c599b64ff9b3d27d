// SPDX-License-Identifier: BSD-3-Clause
// Triangles of Wavefront OBJ files.
#ifndef WideFoVObjFile_h
#define WideFoVObjFile_h

#include "Calibration.h"

namespace wfv::displays
{
struct ObjCorner
{
  std::uint32_t Point;
  std::uint32_t Texture; // index of Textures; NoTexture where the face names none
};

struct ObjMesh
{
  static constexpr std::uint32_t NoTexture = 0xffffffff;

  std::vector<vec3> Points;
  std::vector<vec2> Textures;
  std::vector<std::array<ObjCorner, 3>> Triangles; // larger faces as fans
};

// All faces of the file; everything but v, vt and f is left out. Throws a FileError.
ObjMesh ReadObj(const std::string& path, const std::string& bytes);
}

#endif
