// SPDX-License-Identifier: BSD-3-Clause
// What a process takes to draw one large mesh.
#ifndef WideFoVScaleMemory_h
#define WideFoVScaleMemory_h

#include "Record.h"

#include <string>

namespace wfv
{
namespace scale
{
// Draws a sphere of so many triangles round the eye, in this process, by "stock" VTK or "wide",
// and says what the process then takes: {"peak_mb", "still_mb"}.
bench::Json DrawAndWeigh(const std::string& way, long triangles);

// The same in two processes of their own, started from this program, and their ratios.
bench::Json CompareMemory(const std::string& program, long triangles);
}
}

#endif
