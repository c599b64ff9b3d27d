// SPDX-License-Identifier: BSD-3-Clause
// What vtkWideFoVShaderBuilder adds for points wider than a pixel behind the pre-clip: squares
// that may show on both sides of a seam. Text in, text out.
#ifndef vtkWideFoVPointShaders_h
#define vtkWideFoVPointShaders_h

#include "vtkWideFoVShaderText.h"

namespace wfv
{
namespace point
{
// True where points are drawn so.
bool Draws(const shader::Request& request);

// The geometry stage, behind the mathematics of the view.
std::string GeometrySource(const std::vector<shader::Varying>& varyings);

// Declarations of the fragment stage, behind the mathematics of the view. The stock text is
// changed where it asks for a place inside OpenGL's own points.
std::string FragmentSource(const std::vector<shader::Varying>& varyings, std::string& fragment);
}
}

#endif
