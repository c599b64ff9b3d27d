// SPDX-License-Identifier: BSD-3-Clause
// Angles, for all that computes with them.
#ifndef WideFoVAngles_h
#define WideFoVAngles_h

namespace widefov
{
constexpr double Pi = 3.14159265358979323846;
constexpr double Degree = Pi / 180; // in radians
}

#endif
