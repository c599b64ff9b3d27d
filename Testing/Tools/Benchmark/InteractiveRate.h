// SPDX-License-Identifier: BSD-3-Clause
#ifndef WideFoVInteractiveRate_h
#define WideFoVInteractiveRate_h

namespace wfv
{
namespace bench
{
// Frames a second that a window is asked for while a camera turns, as VTK's interactors do.
constexpr double InteractiveRate = 15;
}
}

#endif
