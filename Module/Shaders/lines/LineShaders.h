// SPDX-License-Identifier: BSD-3-Clause
// What wfv::ShaderBuilder adds for lines of the technique exact: strips of constant
// width along great circles. Text in, text out.
#ifndef WideFoVLineShaders_h
#define WideFoVLineShaders_h

#include "Shaders/ShaderText.h"

namespace wfv
{
namespace line
{
// True where lines are drawn so: the exact variant, but where they are straight anyway.
bool Draws(const shader::Request& request);

// The geometry stage, behind the mathematics of the view and the pre-clip's own.
std::string GeometrySource(
  const shader::Request& request, const std::vector<shader::Varying>& varyings);

// Declarations of the fragment stage, behind the mathematics of the view. The stock text
// is changed where it finds a line's normal from derivatives across the picture.
std::string FragmentSource(
  const shader::Request& r, const std::vector<shader::Varying>& varyings, std::string& fragment);
}
}

#endif
