// SPDX-License-Identifier: BSD-3-Clause
// What wfv::ShaderBuilder adds for points wider than a pixel behind the pre-clip, and for all
// of them on a direction map: squares that may show on both sides of a seam. Text in, text out.
#ifndef WideFoVPointShaders_h
#define WideFoVPointShaders_h

#include "Shaders/ShaderText.h"

namespace wfv
{
namespace point
{
// True where points are drawn so.
bool Draws(const shader::Request& request);

// The geometry stage, behind the mathematics of the view.
std::string GeometrySource(
  const shader::Request& request, const std::vector<shader::Varying>& varyings);

// Declarations of the fragment stage, behind the mathematics of the view. The stock text is
// changed where it asks for a place inside OpenGL's own points.
std::string FragmentSource(const shader::Request& request,
  const std::vector<shader::Varying>& varyings, std::string& fragment);
}
}

#endif
