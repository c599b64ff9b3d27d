// SPDX-License-Identifier: BSD-3-Clause
// What wfv::ShaderBuilder adds for lines: chords, or for the technique exact strips of constant
// width along great circles. Text in, text out.
#ifndef WideFoVLineShaders_h
#define WideFoVLineShaders_h

#include "Shaders/ShaderText.h"

namespace wfv
{
namespace line
{
// True where lines are drawn as strips: the exact variant, but where they are straight anyway.
bool Draws(const shader::Request& request);

// True where a geometry stage draws them as chords.
bool DrawsChords(const shader::Request& request);

// Declarations of the fragment stage of lines that are drawn as stock VTK draws them.
std::string StockFragment(const shader::Request& request, std::string& fragment);

// That stage, behind the mathematics of the view and the pre-clip's own.
std::string ChordSource(const std::vector<shader::Varying>& varyings);

// Declarations of its fragment stage, whose text is changed where light needs a line's normal.
std::string ChordFragment(const shader::Request& request,
  const std::vector<shader::Varying>& varyings, std::string& fragment);

// The geometry stage of strips, behind the mathematics of the view and the pre-clip's own.
std::string GeometrySource(
  const shader::Request& request, const std::vector<shader::Varying>& varyings);

// Declarations of the fragment stage, behind the mathematics of the view. The stock text
// is changed where it finds a line's normal from derivatives across the picture.
std::string FragmentSource(
  const shader::Request& r, const std::vector<shader::Varying>& varyings, std::string& fragment);
}
}

#endif
