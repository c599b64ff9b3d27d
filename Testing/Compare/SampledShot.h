// SPDX-License-Identifier: BSD-3-Clause
// Shots of direction maps made of projections.
#ifndef WideFoVSampledShot_h
#define WideFoVSampledShot_h

#include "Drawing.h"

#include <string>

namespace wfv
{
namespace test
{
// Makes it a shot of a direction map of its size, which shows what the projection does at its
// widest.
void UseMapOf(const std::string& projection, Shot& shot);
}
}

#endif
