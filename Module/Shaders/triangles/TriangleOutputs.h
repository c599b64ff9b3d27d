// SPDX-License-Identifier: BSD-3-Clause
// What the geometry stage of triangles writes, and how it keeps to what OpenGL allows.
#ifndef WideFoVTriangleOutputs_h
#define WideFoVTriangleOutputs_h

#include "Shaders/ShaderText.h"

namespace wfv
{
namespace shader
{
// True where chords may cross a straight seam.
bool CrossesSeam(const Request& request);

// The outputs, and wfvWriteFlat(), which writes those that are flat.
std::string OutputsSource(const Request& request);

// How often the stage is invoked for a triangle, and what for: for each of its runs or eyes, and in
// several parts (emit_parts.glsl) where its vertices have more components than one invocation may
// write. Some drivers refuse to link such a program, Mesa's do not. known: what is not copied, see
// CornerOutputs.
std::string InvocationsSource(
  const Request& request, const std::vector<Varying>& varyings, const Known& known);
}
}

#endif
