// SPDX-License-Identifier: BSD-3-Clause
// What vtkWideFoVDataPass adds to the shaders of a stock mapper. Text in, text out.
#ifndef WideFoVDataShaders_h
#define WideFoVDataShaders_h

#include "Compat/StockEdits.h"

#include <string>

namespace wfv
{
namespace data
{
// Before the mapper replaces its tags, and after. wide: behind a camera that is.
void Prepare(const stock::Traits& traits, bool wide, std::string& geometry, std::string& fragment);
void Finish(const stock::Traits& traits, bool wide, std::string& vertex, std::string& geometry,
  std::string& fragment);
}
}

#endif
