// SPDX-License-Identifier: BSD-3-Clause
#include "FilmPath.h"

#include "Scenes/MeshBuilder.h"
#include "StreamFlight.h"
#include "System/NumberLines.h"
#include "Text/Angles.h"
#include "Text/Messages.h"

#include <vtkQuaternion.h>

#include <algorithm>
#include <cmath>

namespace widefov
{
namespace
{
// Share of a smooth film that gaining speed takes, and losing it.
constexpr double Ramp = 0.15;

// Sine of the smallest angle between up and the direction.
constexpr double SmallestSine = 1e-6;

// Radians: what the arc cosine of a rounded number may be.
constexpr double LeastAngle = 1e-6;

// Anticlockwise about a unit axis, radians.
Vector3 Turned(const Vector3& v, const Vector3& axis, double angle)
{
  return std::cos(angle) * v + std::sin(angle) * Cross(axis, v) +
    ((1 - std::cos(angle)) * Dot(axis, v)) * axis;
}

// Of the camera's axes: right, up, back.
using Quaternion = vtkQuaternion<double>;

Quaternion TurnOf(const Pose& pose)
{
  const Vector3 right = Unit(Cross(pose.Direction, pose.Up));
  const Vector3 up = Cross(right, pose.Direction);
  const double axes[3][3] = { { right[0], up[0], -pose.Direction[0] },
    { right[1], up[1], -pose.Direction[1] }, { right[2], up[2], -pose.Direction[2] } };
  Quaternion turn;
  turn.FromMatrix3x3(axes);
  return turn;
}

// Radians between two turns; what is rounding is 0.
double AngleBetween(const Quaternion& a, const Quaternion& b)
{
  const double dot = a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
  const double angle = 2 * std::acos(std::min(1., std::abs(dot)));
  return angle > LeastAngle ? angle : 0;
}

Pose PoseAt(const Vector3& eye, const Quaternion& turn)
{
  double axes[3][3];
  turn.ToMatrix3x3(axes);
  return { eye, Unit({ { -axes[0][2], -axes[1][2], -axes[2][2] } }),
    Unit({ { axes[0][1], axes[1][1], axes[2][1] } }) };
}

// Knots of the way: when, where, and how fast.
class Way
{
public:
  explicit Way(const std::vector<Pose>& poses);
  Pose At(double share) const;

private:
  struct Knot
  {
    double Time = 0; // 0 to 1
    Vector3 Eye;
    Quaternion Turn;
    Vector3 Speed{ { 0, 0, 0 } };
  };

  void SetTimes();
  void SetSpeeds();

  std::vector<Knot> Knots;
};

Way::Way(const std::vector<Pose>& poses)
{
  for (const Pose& pose : poses)
  {
    Knot knot;
    knot.Eye = pose.Eye;
    knot.Turn = TurnOf(pose);
    this->Knots.push_back(knot);
  }
  this->SetTimes();
  this->SetSpeeds();
}

void Way::SetTimes()
{
  double distance = 0;
  double angle = 0;
  for (std::size_t i = 1; i < this->Knots.size(); i++)
  {
    distance += Length(this->Knots[i].Eye - this->Knots[i - 1].Eye);
    angle += AngleBetween(this->Knots[i].Turn, this->Knots[i - 1].Turn);
  }
  for (std::size_t i = 1; i < this->Knots.size(); i++)
  {
    const double far = Length(this->Knots[i].Eye - this->Knots[i - 1].Eye);
    const double wide = AngleBetween(this->Knots[i].Turn, this->Knots[i - 1].Turn);
    this->Knots[i].Time = this->Knots[i - 1].Time + (distance > 0 ? far / distance : 0) +
      (angle > 0 ? wide / angle : 0);
  }
  const double total = this->Knots.back().Time;
  for (Knot& knot : this->Knots)
  {
    knot.Time = total > 0 ? knot.Time / total : 0;
  }
}

// Through the neighbours of a knot; none where the eye rests before it or after it.
void Way::SetSpeeds()
{
  for (std::size_t i = 0; i < this->Knots.size(); i++)
  {
    const Knot& before = this->Knots[i > 0 ? i - 1 : i];
    const Knot& after = this->Knots[std::min(i + 1, this->Knots.size() - 1)];
    const bool first = i == 0 || this->Knots[i].Eye != before.Eye;
    const bool last = i + 1 == this->Knots.size() || this->Knots[i].Eye != after.Eye;
    if (first && last && after.Time > before.Time)
    {
      this->Knots[i].Speed = (1 / (after.Time - before.Time)) * (after.Eye - before.Eye);
    }
  }
}

Pose Way::At(double share) const
{
  const auto after = std::upper_bound(this->Knots.begin(), this->Knots.end(), share,
    [](double time, const Knot& knot) { return time < knot.Time; });
  if (after == this->Knots.begin() || after == this->Knots.end())
  {
    const Knot& end = after == this->Knots.end() ? this->Knots.back() : this->Knots.front();
    return PoseAt(end.Eye, end.Turn);
  }
  const Knot& a = *(after - 1);
  const Knot& b = *after;
  const double span = b.Time - a.Time;
  const double t = (share - a.Time) / span;
  const double t2 = t * t;
  const double t3 = t2 * t;
  // cubic Hermite
  const Vector3 eye = (2 * t3 - 3 * t2 + 1) * a.Eye + ((t3 - 2 * t2 + t) * span) * a.Speed +
    (3 * t2 - 2 * t3) * b.Eye + ((t3 - t2) * span) * b.Speed;
  return PoseAt(eye, a.Turn.Slerp(t, b.Turn));
}

// About an axis through a centre, to the right of who looks at the centre from outside.
FilmPath Around(const Pose& pose, const Vector3& axis, const Vector3& centre, double degrees)
{
  FilmPath path;
  path.Closed = degrees != 0 && std::fmod(degrees, 360) == 0;
  path.At = [=](double share) {
    const double angle = share * degrees * Degree;
    return Pose{ centre + Turned(pose.Eye - centre, axis, angle),
      Turned(pose.Direction, axis, angle), Turned(pose.Up, axis, angle) };
  };
  return path;
}

// Round what --look-at names, or the middle of the data. An eye that is there goes back until it
// sees all of them.
FilmPath Orbit(const Scene& scene, const Options& o, Pose pose)
{
  double b[6] = { 0, 0, 0, 0, 0, 0 };
  SceneBounds(scene, b);
  const Vector3 middle{ { 0.5 * (b[0] + b[1]), 0.5 * (b[2] + b[3]), 0.5 * (b[4] + b[5]) } };
  const Vector3 centre = o.LookAt.value_or(middle);
  const Vector3 up = pose.Up;
  const Vector3 arm = pose.Eye - centre;
  const double size = std::hypot(b[1] - b[0], b[3] - b[2], b[5] - b[4]);
  if (Length(arm - Dot(arm, up) * up) <= SmallestSine * size)
  {
    pose.Eye = centre + -(size > 0 ? size : 1) * pose.Direction;
  }
  else if (!o.LookAt && !o.Direction)
  {
    pose.Direction = Unit(centre - pose.Eye);
  }
  return Around(pose, up, centre, o.Film.Sweep);
}
}

FilmPath PathThrough(const std::vector<Pose>& poses)
{
  const Way way(poses);
  return { [way](double share) { return way.At(share); } };
}

std::vector<Pose> ReadPoses(const std::string& path, const Vector3& up)
{
  std::vector<Pose> poses;
  for (const NumberLine& line : ReadNumberLines(path, "poses of a camera"))
  {
    const std::vector<double>& v = line.Numbers;
    if (v.size() != 6 && v.size() != 9)
    {
      Fail(line.Where + " has " + std::to_string(v.size()) +
        " numbers; a pose is x y z of the eye, of the direction, and of up, which may be left out");
    }
    Pose pose{ { { v[0], v[1], v[2] } }, { { v[3], v[4], v[5] } }, up };
    if (v.size() == 9)
    {
      pose.Up = { { v[6], v[7], v[8] } };
    }
    if (!(Length(pose.Direction) > 0) || !(Length(pose.Up) > 0) ||
      Length(Cross(Unit(pose.Direction), Unit(pose.Up))) < SmallestSine)
    {
      Fail(line.Where + ": the direction is no direction, or parallel to up; correct it");
    }
    pose.Direction = Unit(pose.Direction);
    poses.push_back(pose);
  }
  if (poses.empty())
  {
    Fail(path + " has no pose; a line is x y z of the eye, and of the direction");
  }
  if (poses.size() == 1)
  {
    Say("warning: " + path + " has one pose: the camera stands still");
  }
  return poses;
}

FilmPath MakeFilmPath(const Scene& scene, const Options& o)
{
  const Pose pose = MakePose(scene, o);
  const std::string& kind = o.Film.Kind;
  if (kind == "turn")
  {
    return Around(pose, pose.Up, pose.Eye, -o.Film.Sweep);
  }
  if (kind == "orbit")
  {
    return Orbit(scene, o, pose);
  }
  if (kind == "path")
  {
    return PathThrough(ReadPoses(o.Film.Path, pose.Up));
  }
  if (kind == "fly")
  {
    return PathThrough(FlightAlong(scene, o.Look, o.Eye, pose.Up));
  }
  return { [pose](double) { return pose; }, true };
}

double ShareOfWay(int frame, int frames, bool closed, bool smooth)
{
  const double whole = closed ? frames : std::max(1, frames - 1);
  const double t = std::min(1., frame / whole);
  if (!smooth)
  {
    return t;
  }
  const auto gain = [](double u) {
    const double x = std::min(1., u / Ramp);
    // the integral of a smooth step, then of 1
    return Ramp * (x * x * x - 0.5 * x * x * x * x) + std::max(0., u - Ramp);
  };
  return t <= 0.5 ? gain(t) / (1 - Ramp) : 1 - gain(1 - t) / (1 - Ramp);
}
}
