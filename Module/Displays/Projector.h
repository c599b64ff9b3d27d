// SPDX-License-Identifier: BSD-3-Clause
// Projectors that stand in a room, and the tables that follow from where their rays end.
#ifndef WideFoVDisplaysProjector_h
#define WideFoVDisplaysProjector_h

#include "Surface.h"
#include "Table.h"

namespace wfv::displays
{
struct Projector
{
  vec3 Position{ 0 };       // metres, room
  glm::dmat3 Rotation{ 1 }; // from the projector's coordinates to the room's
  Content Lens;             // unit direction of a place u, v in the projector's coordinates
};

// Rotation of a projector that looks along `direction` with `up` upwards in its picture. Both have
// a length and are not parallel.
glm::dmat3 LookAlong(const vec3& direction, const vec3& up);

// A lens without distortion. throwRatio: distance / width of the picture; shift: by how much the
// picture is moved to the right and upwards, in its widths and heights.
Content ThrowLens(double throwRatio, double aspect, vec2 shift);

// A projector that was calibrated as OpenCV calibrates cameras: focal lengths and principal point
// in pixels from the centre of the upper left one.
struct CameraLens
{
  vec2 Focal{ 1, 1 };
  vec2 Axis{ 0, 0 };
  std::array<double, 5> Distortion{}; // k1 k2 p1 p2 k3
  vec2 Size{ 1, 1 };                  // pixels
  vec3 operator()(vec2 uv) const;
};

// A mirror ball, or the part of one that the projector sees.
struct SphereMirror
{
  vec3 Center{ 0 };
  double Radius = 1; // metres
};

// The points of the surface that the pixels light, by the mirror where there is one. Throws a
// FileError where no ray of the projector meets the surface.
Table CastTable(const Projector& projector, const Surface& surface, int width, int height,
  const std::optional<SphereMirror>& mirror = {});
}

#endif
