// SPDX-License-Identifier: BSD-3-Clause
// Where the eye is and which way it looks, with an upright horizon: pure geometry.
#ifndef WideFoVNavigator_h
#define WideFoVNavigator_h

#include "Scenes/Look.h"

namespace widefov
{
class Navigator
{
public:
  // `up` is what stays upright; `direction` is where the eye looks at first; `head` is the
  // up of the picture, which counts where the direction is vertical. Any lengths but zero.
  Navigator(const Vector3& eye, const Vector3& direction, const Vector3& head, const Vector3& up);

  const Vector3& GetEye() const { return this->Eye; }
  Vector3 GetDirection() const; // unit length
  Vector3 GetUp() const;        // unit length, of the picture

  // Degrees: to the right of where it looked first, above the horizon.
  double GetYaw() const;
  double GetPitch() const;

  // A direction in view coordinates (x right, y up, z behind) as one of the world.
  Vector3 ToWorld(const Vector3& view) const;

  // A direction of the world that a hand holds, and how the eye looked when it was grabbed.
  struct Grip
  {
    Vector3 World{ { 0, 0, -1 } }; // unit length
    double Pitch = 0;              // radians
  };

  // Takes hold of what the direction `view` of the picture shows (unit length, view
  // coordinates).
  Grip Grab(const Vector3& view) const;

  // Turns the eye until the direction `view` shows what is held, wherever it looked meanwhile.
  // The azimuth is always right. So is the latitude, within 60 degrees of ahead and of behind,
  // as far as an upright horizon allows; farther to the sides, where raising the eye hardly
  // raises anything, the eye follows less and less, and at the very side it is raised no more.
  void Pull(const Grip& grip, const Vector3& view);

  // Turns the eye to the right and up, degrees; it stops at the zenith and the nadir.
  void Turn(double right, double up);

  // The same, and carries the eye round the centre, which keeps its place in the picture.
  void Orbit(const Vector3& center, double right, double up);

  // Moves the eye: to the right, along what stays upright, ahead. Scene units.
  void Fly(double right, double up, double ahead);

  void MoveTo(const Vector3& eye) { this->Eye = eye; }

private:
  Vector3 ToView(const Vector3& world) const;

  Vector3 Eye;
  Vector3 Up;     // what stays upright
  Vector3 Ahead;  // horizontal, where yaw is zero
  Vector3 Right;  // horizontal
  double Yaw = 0; // radians
  double Pitch = 0;
};
}

#endif
