// SPDX-License-Identifier: BSD-3-Clause
// The fragment stage of VTK's skybox, by the ray of each pixel.
#ifndef WideFoVSkyShaders_h
#define WideFoVSkyShaders_h

#include "Shaders/ShaderBuilder.h"

#include <string>

namespace wfv
{
namespace sky
{
// What the texture is.
enum class Kind
{
  Cube,
  Sphere,
  Halves, // two spheres, the left eye's above
  Floor
};

// A fragment stage of its own: a gradient by direction.
std::string GradientSource(const ShaderBuilder::Request& r);

// Rewrites VTK's text for the view of the request.
void Finish(const ShaderBuilder::Request& r, Kind kind, std::string& fragment);
}
}

#endif
