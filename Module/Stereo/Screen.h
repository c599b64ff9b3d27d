// SPDX-License-Identifier: BSD-3-Clause
// A flat screen in a room, and who stands before it. Room coordinates: x right, y up, z behind,
// in any unit. Source of the frustum: M. Deering, High Resolution Virtual Reality, SIGGRAPH 1992;
// it is what VTK's off-axis projection and ParaView's CAVE mode compute.
#ifndef WideFoVScreen_h
#define WideFoVScreen_h

#include "Projections/Projection.h"

#include <array>
#include <string>

namespace wfv
{
// Three corners of a rectangle, as its viewers see it.
struct Screen
{
  vec3 LowerLeft{ -1, -1, -1 };
  vec3 LowerRight{ 1, -1, -1 };
  vec3 UpperRight{ 1, 1, -1 };
};

// An empty string, or why these are not the corners of a screen. Corners are measured: sides
// that are nearly at right angles pass, and the upper edge is taken at right angles.
WFV_EXPORT std::string CheckScreen(const Screen& screen);

// Where a head is, and how it is turned: a quaternion x, y, z, w of any length but 0, from head
// (x right, y up, z behind) to room coordinates.
struct Head
{
  vec3 Position{ 0 };
  std::array<double, 4> Turn{ { 0, 0, 0, 1 } };
};

// A vector of the head in room coordinates.
WFV_EXPORT vec3 TurnedWith(const Head& head, const vec3& vector);

// The eye of that side; the middle one is the head's position.
WFV_EXPORT vec3 EyeOf(const Head& head, double interpupillaryDistance, Eye eye);

// What an eye sees through a screen: a perspective along the screen's normal.
struct ScreenFrustum
{
  vec3 Right, Up, Back; // unit vectors of the picture; Back points to the viewers
  double Distance;      // of the eye from the screen's plane; not above 0: it is not before it
  vec2 Half;            // half its width and height, at the distance 1 from the eye
  vec2 Center;          // NDC of the point of the picture that is opposite to the eye
};

// Where the eye is not before the screen, that of an eye just before it: never infinite.
WFV_EXPORT ScreenFrustum LookThrough(const Screen& screen, const vec3& eye);

// From that eye to a place of the screen's picture, NDC; room coordinates, unit length.
WFV_EXPORT vec3 DirectionThrough(const ScreenFrustum& frustum, const vec2& ndc);
}

#endif
