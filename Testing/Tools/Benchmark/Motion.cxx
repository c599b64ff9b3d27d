// SPDX-License-Identifier: BSD-3-Clause
#include "Motion.h"

#include "Scenes/MeshBuilder.h"
#include "Projections/Projection.h"

#include <algorithm>
#include <cmath>

namespace wfv
{
namespace bench
{
namespace
{
using widefov::Vector3;
using widefov::operator+;
using widefov::operator*;

// Of a film, degrees a frame. Sixty frames go round the circle: in a room five metres across a
// slow walk, at thirty frames a second.
constexpr double FilmTurn = 1;
constexpr double FilmStep = 6;

// Of first pictures, degrees: the golden angle. No direction comes back, and none is near one of
// the frames just before.
constexpr double FirstTurn = 137.50776405003785;

// Counterclockwise, seen from where the axis points to.
Vector3 Turned(const Vector3& v, const Vector3& axis, double degrees)
{
  const double angle = degrees * WFV_PI / 180;
  const double along = axis[0] * v[0] + axis[1] * v[1] + axis[2] * v[2];
  return std::cos(angle) * v + std::sin(angle) * widefov::Cross(axis, v) +
    ((1 - std::cos(angle)) * along) * axis;
}

// Turned by `turn`, and moved from the middle of the circle to the place at the angle `place`.
widefov::Pose OnCircle(const widefov::Pose& start, double radius, double turn, double place)
{
  widefov::Pose pose = start;
  const Vector3 right = widefov::Unit(widefov::Cross(start.Direction, start.Up));
  pose.Eye = start.Eye + radius * Turned(right, start.Up, place);
  pose.Direction = Turned(start.Direction, start.Up, turn);
  return pose;
}
}

std::vector<std::string> ModeNames()
{
  return { "still", "turn", "film", "first" };
}

std::string NameOf(Mode mode)
{
  return ModeNames()[static_cast<std::size_t>(mode)];
}

Mode ModeOf(const std::string& name)
{
  const std::vector<std::string> names = ModeNames();
  return static_cast<Mode>(std::find(names.begin(), names.end(), name) - names.begin());
}

widefov::Pose PoseAt(const widefov::Pose& start, double radius, const Motion& motion, int frame)
{
  switch (motion.Mode)
  {
    case Mode::Turn:
      return OnCircle(start, 0, frame * motion.Degrees, 0);
    case Mode::Film:
      return OnCircle(start, radius, frame * FilmTurn, frame * FilmStep);
    case Mode::First:
      // the other way round, so that no two frames look along the circle alike
      return OnCircle(start, radius, frame * FirstTurn, -frame * FirstTurn);
    default:
      return start;
  }
}
}
}
