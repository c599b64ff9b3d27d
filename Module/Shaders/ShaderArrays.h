// SPDX-License-Identifier: BSD-3-Clause
// Arrays of floats between the vertex and the fragment stage of a stock mapper.
#ifndef WideFoVShaderArrays_h
#define WideFoVShaderArrays_h

#include "Compat/StockEdits.h"

#include <string>

namespace wfv
{
// GLSL 1.50 has no arrays of arrays, so a geometry stage cannot take an array from each
// vertex: arrays between the stages become vectors (scalars would use up the slots), and
// arrays again where they are used.
void FlattenArrays(const stock::Traits& traits, std::string& vertex, std::string& fragment);
}

#endif
