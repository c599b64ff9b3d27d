// SPDX-License-Identifier: BSD-3-Clause
// What wfv::ShaderBuilder adds for triangles that a geometry stage covers by shapes. Text in, text
// out.
#ifndef WideFoVTriangleShaders_h
#define WideFoVTriangleShaders_h

#include "Shaders/ShaderText.h"

namespace wfv
{
namespace triangle
{
// True if a geometry stage covers the pictures of triangles, and the fragment stage decides by the
// ray of each pixel.
bool Covers(const shader::Request& request);

// The geometry stage, behind the mathematics of the view and of edges.
std::string GeometrySource(
  const shader::Request& request, const std::vector<shader::Varying>& varyings);

// Declarations of the fragment stage, behind the mathematics of the view. The stock text is changed
// where it finds a flat normal.
std::string FragmentSource(
  const shader::Request& r, const std::vector<shader::Varying>& varyings, std::string& fragment);
}
}

#endif
