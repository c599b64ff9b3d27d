// SPDX-License-Identifier: BSD-3-Clause
// What vtkWideFoVShaderBuilder adds for lines: strips of constant width along great
// circles. Text in, text out.
#ifndef vtkWideFoVLineShaders_h
#define vtkWideFoVLineShaders_h

#include "vtkWideFoVVaryings.h"

namespace wfv
{
// The geometry stage, behind the mathematics of the view and the pre-clip's own.
std::string LineGeometry(const std::vector<Varying>& varyings);

// Declarations of the fragment stage, behind the mathematics of the view. The stock text
// is changed where it finds a line's normal from derivatives across the picture.
std::string LineFragment(const std::vector<Varying>& varyings, bool exact, std::string& fragment);
}

#endif
