// SPDX-License-Identifier: BSD-3-Clause
// The part of the shader builder for what is no mesh: spheres, cylinders, tubes and splats.
// A geometry stage of our own covers the picture of each, the fragment stage meets the
// surface with the ray of each pixel. Text in, text out.
#ifndef WideFoVQuadricShaders_h
#define WideFoVQuadricShaders_h

#include "Shaders/ShaderBuilder.h"

#include <string>

namespace wfv
{
namespace quadric
{
// True for the kinds that this part draws.
bool Draws(wfv::ShaderBuilder::Primitive kind);

// As wfv::ShaderBuilder::Prepare and ::Finish, for those kinds.
void Prepare(
  const wfv::ShaderBuilder::Request& request, std::string& geometry, std::string& fragment);
void Finish(const wfv::ShaderBuilder::Request& request, std::string& vertex, std::string& geometry,
  std::string& fragment);
}
}

#endif
