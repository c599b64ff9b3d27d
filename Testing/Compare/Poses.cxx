// SPDX-License-Identifier: BSD-3-Clause
#include "Poses.h"

#include <algorithm>

namespace wfv
{
namespace test
{
namespace
{
// Rodrigues' rotation of p about the unit axis k by an angle in degrees.
vec3 Rotate(const vec3& p, const vec3& k, double degrees)
{
  const double a = degrees * WFV_PI / 180;
  return p * std::cos(a) + glm::cross(k, p) * std::sin(a) +
    k * (glm::dot(k, p) * (1 - std::cos(a)));
}
}

NamedPose Turned(const NamedPose& pose, double yaw, double pitch, const std::string& name)
{
  NamedPose p = pose;
  p.Name = name;
  p.Direction = Rotate(p.Direction, p.Up, -yaw);
  const vec3 right = glm::normalize(glm::cross(p.Direction, p.Up));
  p.Direction = Rotate(p.Direction, right, pitch);
  p.Up = Rotate(p.Up, right, pitch);
  return p;
}

std::vector<NamedPose> PlainPoses()
{
  NamedPose middle;
  middle.Name = "middle";
  NamedPose off;
  off.Eye = vec3(0.071, -0.043, 0.029);
  return { middle, Turned(off, 33.7, -21.3, "off the middle, turned") };
}

std::vector<NamedPose> SweptPoses(int n)
{
  const NamedPose middle;
  const auto vertex = [n](int k) { return std::atan2(k, n - k) * 180 / WFV_PI; };
  std::vector<NamedPose> poses;
  for (double offset : { 0.0, 1e-6, 1e-4, 1e-2, 0.25 })
  {
    char text[40];
    std::snprintf(text, sizeof text, "%g", offset);
    const std::string by = text;
    poses.push_back(Turned(middle, vertex(7) + offset, 0, "seam at vertex + " + by));
    poses.push_back(Turned(middle, 0, vertex(5) + offset, "pole at vertex + " + by));
    poses.push_back(Turned(middle, vertex(3) + offset, 90 - offset, "axis at vertex + " + by));
  }
  return poses;
}

std::vector<NamedPose> WallPoses(int n)
{
  const double next = std::tan(0.5 * WFV_PI / n); // the vertex beside the middle of a wall
  std::vector<NamedPose> poses(3);
  poses[0].Name = "eye on a vertex";
  poses[0].Eye = vec3(1, 0, 0);
  poses[1].Name = "eye on an edge";
  poses[1].Eye = vec3(1, float(next) / 2, 0);
  poses[2].Name = "eye on a face";
  poses[2].Eye = vec3(1, float(next) / 2, float(next) / 4);
  return poses;
}

Shot MakeShot(const std::string& projection, double fov, const NamedPose& pose)
{
  const Projection& p = *FindProjection(projection);
  Shot s;
  s.Projection = projection;
  s.Options.HorizontalFov = fov;
  s.Options.VerticalFov = std::clamp(fov / 2, p.MinVerticalFov, p.MaxVerticalFov);
  if (p.Axis == Family::Azimuthal)
  {
    s.Width = s.Height = 360;
    s.Options.VerticalFov = fov;
  }
  if (p.Axis == Family::Faces)
  {
    s.Width = 540; // square faces
    s.Height = 360;
  }
  s.Options.Radii = { { 0.02, 4 } };
  s.Eye = pose.Eye;
  s.Direction = pose.Direction;
  s.Up = pose.Up;
  return s;
}

double WidestDrawn(const Projection& p)
{
  constexpr double Planar = 120;
  return p.Axis == Family::Planar ? Planar : p.MaxHorizontalFov;
}

std::vector<double> FovsOf(const Projection& p, const std::vector<double>& fovs)
{
  // the families' first ones stand for the others at what is not the widest
  const bool first = p.Name == "equirectangular" || p.Name == "hammer" ||
    p.Name == "azimuthal-equidistant" || p.Name == "perspective";
  std::vector<double> own;
  for (double fov : fovs)
  {
    if (first && fov >= p.MinHorizontalFov && fov <= p.MaxHorizontalFov)
    {
      own.push_back(fov);
    }
  }
  return first ? own : std::vector<double>{ p.MaxHorizontalFov };
}
}
}
