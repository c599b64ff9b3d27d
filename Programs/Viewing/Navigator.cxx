// SPDX-License-Identifier: BSD-3-Clause
#include "Navigator.h"

#include "Scenes/MeshBuilder.h"
#include "Text/Angles.h"

#include <algorithm>
#include <cmath>

namespace widefov
{
namespace
{
// A direction whose horizontal part is shorter (of a unit vector) has no azimuth: beyond
// the rounding of unit vectors, far below a pixel.
constexpr double SmallestHorizontal = 1e-9;

// Cosine of the azimuth within which a drag raises the eye as far as it takes: 60 degrees.
constexpr double FullEffect = 0.5;

// To (-pi, pi].
double Wrapped(double angle)
{
  return std::remainder(angle, 2 * Pi);
}

double ClampPitch(double pitch)
{
  return std::clamp(pitch, -0.5 * Pi, 0.5 * Pi);
}

// How much of the pitch that would be needed is taken: all where raising the eye by an angle
// raises the direction `view` by half of that or more, nothing where it raises it by nothing.
double Share(const Vector3& view, double pitch)
{
  const double ahead = -view[1] * std::sin(pitch) - view[2] * std::cos(pitch);
  const double across = std::hypot(ahead, view[0]);
  if (across < SmallestHorizontal)
  {
    return 1; // straight up or down
  }
  const double t = std::min(1., std::abs(ahead) / across / FullEffect);
  return t * t * (3 - 2 * t);
}

// The pitch at which the direction (x, y, z) of the view has the given sine of latitude:
// y cos(pitch) - z sin(pitch) = sine, of the two the one nearer to `before`.
double SolvePitch(const Vector3& view, double sine, double before)
{
  const double reach = std::hypot(view[1], view[2]);
  if (reach < SmallestHorizontal)
  {
    return before; // a direction along x keeps its latitude in every pitch
  }
  const double middle = std::atan2(-view[2], view[1]);
  const double half = std::acos(std::clamp(sine / reach, -1., 1.));
  double best = 0;
  double least = 4 * Pi;
  for (const double candidate : { Wrapped(middle + half), Wrapped(middle - half) })
  {
    // what lies beyond the zenith counts by where it is clamped to, and as far away
    const double pitch = ClampPitch(candidate);
    const double cost = std::abs(pitch - before) + 2 * std::abs(candidate - pitch);
    if (cost < least)
    {
      least = cost;
      best = pitch;
    }
  }
  return best;
}
}

Navigator::Navigator(
  const Vector3& eye, const Vector3& direction, const Vector3& head, const Vector3& up)
  : Eye(eye)
  , Up(Unit(up))
{
  const Vector3 ahead = Unit(direction);
  const double sine = std::clamp(Dot(ahead, this->Up), -1., 1.);
  Vector3 horizontal = ahead - sine * this->Up;
  this->Pitch = std::atan2(sine, Length(horizontal));
  if (Length(horizontal) < SmallestHorizontal)
  {
    // looking straight up, the top of the picture is behind; straight down, ahead
    horizontal = (sine > 0 ? -1. : 1.) * (head - Dot(head, this->Up) * this->Up);
  }
  if (Length(horizontal) < SmallestHorizontal)
  {
    const Vector3 axis{ { std::abs(this->Up[0]) < 0.5 ? 1. : 0., 0,
      std::abs(this->Up[0]) < 0.5 ? 0. : 1. } };
    horizontal = axis - Dot(axis, this->Up) * this->Up;
  }
  this->Ahead = Unit(horizontal);
  this->Right = Cross(this->Ahead, this->Up);
}

double Navigator::GetYaw() const
{
  return this->Yaw / Degree;
}

double Navigator::GetPitch() const
{
  return this->Pitch / Degree;
}

Vector3 Navigator::ToWorld(const Vector3& v) const
{
  const double ahead = -v[1] * std::sin(this->Pitch) - v[2] * std::cos(this->Pitch);
  const double up = v[1] * std::cos(this->Pitch) - v[2] * std::sin(this->Pitch);
  const double s = std::sin(this->Yaw);
  const double c = std::cos(this->Yaw);
  return (c * ahead - s * v[0]) * this->Ahead + (s * ahead + c * v[0]) * this->Right +
    up * this->Up;
}

Vector3 Navigator::ToView(const Vector3& world) const
{
  return { { Dot(world, this->ToWorld({ { 1, 0, 0 } })), Dot(world, this->ToWorld({ { 0, 1, 0 } })),
    Dot(world, this->ToWorld({ { 0, 0, 1 } })) } };
}

Vector3 Navigator::GetDirection() const
{
  return this->ToWorld({ { 0, 0, -1 } });
}

Vector3 Navigator::GetUp() const
{
  return this->ToWorld({ { 0, 1, 0 } });
}

Navigator::Grip Navigator::Grab(const Vector3& view) const
{
  return { this->ToWorld(view), this->Pitch };
}

void Navigator::Pull(const Grip& grip, const Vector3& view)
{
  const Vector3& world = grip.World;
  const double solved = SolvePitch(view, Dot(world, this->Up), grip.Pitch);
  this->Pitch = grip.Pitch + Share(view, grip.Pitch) * (solved - grip.Pitch);
  const Vector3 shown = this->ToWorld(view);
  const double shownAhead = Dot(shown, this->Ahead);
  const double shownRight = Dot(shown, this->Right);
  const double ahead = Dot(world, this->Ahead);
  const double right = Dot(world, this->Right);
  if (std::min(std::hypot(shownAhead, shownRight), std::hypot(ahead, right)) > SmallestHorizontal)
  {
    this->Yaw = Wrapped(this->Yaw + std::atan2(right, ahead) - std::atan2(shownRight, shownAhead));
  }
}

void Navigator::Turn(double right, double up)
{
  this->Yaw = Wrapped(this->Yaw + right * Degree);
  this->Pitch = ClampPitch(this->Pitch + up * Degree);
}

void Navigator::Orbit(const Vector3& center, double right, double up)
{
  const Vector3 view = this->ToView(center - this->Eye);
  this->Turn(right, up);
  this->Eye = center - this->ToWorld(view);
}

void Navigator::Fly(double right, double up, double ahead)
{
  this->Eye = this->Eye + right * this->ToWorld({ { 1, 0, 0 } }) + up * this->Up +
    ahead * this->GetDirection();
}
}
