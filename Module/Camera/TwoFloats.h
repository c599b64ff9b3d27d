// SPDX-License-Identifier: BSD-3-Clause
// Numbers in double for shaders, as the sum of two floats.
#ifndef WideFoVTwoFloats_h
#define WideFoVTwoFloats_h

namespace wfv
{
// What a float has too few digits for.
inline float LowPart(double x)
{
  // volatile: without it GCC 12 vectorizes loops over this at -O2, and makes some of the parts 0
  const volatile float high = static_cast<float>(x);
  return static_cast<float>(x - high);
}
}

#endif
