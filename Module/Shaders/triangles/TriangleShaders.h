// SPDX-License-Identifier: BSD-3-Clause
// What wfv::ShaderBuilder adds for triangles that a geometry stage draws: shapes that cover their
// pictures, or smaller triangles that are projected. Text in, text out.
#ifndef WideFoVTriangleShaders_h
#define WideFoVTriangleShaders_h

#include "Shaders/ShaderText.h"

namespace wfv
{
namespace triangle
{
// True where the geometry stage cuts triangles into smaller ones, which are projected.
bool Cuts(const shader::Request& request);

// True where it covers them, and the fragment stage decides by the ray of each pixel.
bool Covers(const shader::Request& request);

// The geometry stage of either, behind the mathematics of the view and of edges.
std::string GeometrySource(
  const shader::Request& request, const std::vector<shader::Varying>& varyings);

// Declarations of the fragment stage, behind the mathematics of the view. The stock text is changed
// where it finds a flat normal.
std::string FragmentSource(
  const shader::Request& r, const std::vector<shader::Varying>& varyings, std::string& fragment);
}
}

#endif
