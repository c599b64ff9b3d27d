// SPDX-License-Identifier: BSD-3-Clause
// Compares the ends of projectors' rays with closed forms.
#include "DisplayFiles.h"
#include "Displays/Projector.h"

#include <gtest/gtest.h>

using namespace wfv;
using namespace wfv::displays;
using namespace wfv::test;

namespace
{
// Metres: rooms of ten metres in double.
constexpr double Rounding = 1e-11;

// Metres: a ball of 128 x 64 quads, of the radius 2, lies so far inside of the sphere at the most.
constexpr double ChordError = 2 * (1 - 0.9988);

Projector Straight(const vec3& position, const vec3& direction)
{
  Projector projector;
  projector.Position = position;
  projector.Rotation = LookAlong(direction, vec3(0, 1, 0));
  projector.Lens = ThrowLens(1, 2, vec2(0, 0));
  return projector;
}

std::string BallText(const vec3& center, double radius)
{
  constexpr int across = 128;
  constexpr int down = 64;
  std::string text;
  for (int i = 0; i <= down * across; i++)
  {
    const double longitude = 2 * WFV_PI * (i % across) / across;
    const double latitude = WFV_PI * (double(i / across) / down - 0.5);
    const vec3 p = center +
      radius *
        vec3(std::cos(latitude) * std::sin(longitude), std::sin(latitude),
          std::cos(latitude) * std::cos(longitude));
    text += "v " + Text({ p.x, p.y, p.z });
  }
  for (int j = 0; j < down; j++)
  {
    for (int i = 0; i < across; i++)
    {
      const auto index = [&](int x, int y) {
        return std::to_string(1 + std::min(y, down - 1) * across + x % across) + " ";
      };
      text += "f " + index(i, j) + index(i + 1, j) + index(i + 1, j + 1) + index(i, j + 1) + "\n";
    }
  }
  return text;
}
}

// Every point lies on the sphere and on the pixel's ray; a dome ends at its rim.
TEST(Surfaces, Dome)
{
  SphereSurface dome;
  dome.Center = vec3(0, 1, 0);
  dome.Radius = 5;
  dome.HalfAngle = 90;
  const Projector projector = Straight(vec3(0.5, 0.5, 1), vec3(0, 1, -1));
  const Table table = CastTable(projector, dome, 32, 16);
  int lit = 0;
  for (std::size_t i = 0; i < table.Count(); i++)
  {
    const vec2 uv((double(i % 32) + 0.5) / 32, (double(i / 32) + 0.5) / 16);
    const vec3 ray = projector.Rotation * projector.Lens(uv);
    const vec3& p = table.Values[i];
    if (!std::isnan(p.x))
    {
      lit++;
      EXPECT_NEAR(glm::length(p - dome.Center), 5, Rounding);
      EXPECT_LT(glm::length(glm::cross(p - projector.Position, ray)), Rounding);
      EXPECT_GE(p.y, 1 - Rounding);
    }
  }
  EXPECT_EQ(lit, 32 * 16);
  EXPECT_EQ(dome.Meet(vec3(0, 1, 0), vec3(0, -1, 0)), Surface::Nowhere);
}

// Throw ratio and shift: a picture that is as wide as it is far, moved up by half its height.
TEST(Surfaces, PlaneAndShift)
{
  PlaneSurface wall;
  wall.LowerLeft = vec3(-5, -5, -4);
  wall.LowerRight = vec3(5, -5, -4);
  wall.UpperRight = vec3(5, 5, -4);
  Projector projector = Straight(vec3(0), vec3(0, 0, -1));
  projector.Lens = ThrowLens(1, 2, vec2(0, 0.5));
  const Table table = CastTable(projector, wall, 8, 4);
  EXPECT_LT(glm::length(table.Values[0] - vec3(-2 + 0.25, 0.25, -4)), Rounding);
  EXPECT_LT(glm::length(table.Values[31] - vec3(2 - 0.25, 2 - 0.25, -4)), Rounding);
  EXPECT_EQ(wall.Meet(vec3(0), vec3(0, 0, 1)), Surface::Nowhere);
  EXPECT_EQ(wall.Meet(vec3(0), vec3(1, 0, 0)), Surface::Nowhere);
}

TEST(Surfaces, Cylinder)
{
  CylinderSurface screen;
  screen.Radius = 3;
  screen.Low = -1;
  screen.High = 2;
  screen.HalfAngle = 120;
  const Table table = CastTable(Straight(vec3(0, 0, 1), vec3(0.3, 0.1, -1)), screen, 16, 8);
  for (const vec3& p : table.Values)
  {
    if (!std::isnan(p.x))
    {
      EXPECT_NEAR(std::hypot(p.x, p.z), 3, Rounding);
    }
  }
  EXPECT_NEAR(screen.Meet(vec3(0), vec3(0, 0, -1)), 3, Rounding);
  EXPECT_EQ(screen.Meet(vec3(0), vec3(0, 0, 1)), Surface::Nowhere); // behind, where it is open
  EXPECT_EQ(screen.Meet(vec3(0), vec3(0, 1, 0)), Surface::Nowhere); // along its axis
}

// An object of triangles is as near as the ball that they approximate, and what is behind is
// hidden.
TEST(Surfaces, Mesh)
{
  const TemporaryFile file("ball.obj", BallText(vec3(1, 0, -6), 2));
  const std::unique_ptr<Surface> mesh = ReadSurface(file.Path);
  SphereSurface ball;
  ball.Center = vec3(1, 0, -6);
  ball.Radius = 2;
  int hits = 0;
  for (int i = 0; i < 400; i++)
  {
    const vec3 ray = glm::normalize(vec3((i % 20) / 20. - 0.3, double(i / 20) / 20. - 0.5, -1));
    const double expected = ball.Meet(vec3(0), ray);
    const vec3 from = vec3(0) - ball.Center;
    const double miss = glm::length(glm::cross(from, ray));
    if (std::abs(miss - 2) > 0.1) // not along the rim
    {
      const double found = mesh->Meet(vec3(0), ray);
      EXPECT_EQ(found == Surface::Nowhere, expected == Surface::Nowhere);
      hits += found < Surface::Nowhere ? 1 : 0;
      if (found < Surface::Nowhere)
      {
        const double slant = std::sqrt(1 - miss * miss / 4);
        EXPECT_NEAR(found, expected, ChordError / slant);
      }
    }
  }
  EXPECT_GT(hits, 100);
}

// A mirror ball: the ray, the normal and the ray that goes on lie in a plane, at equal angles.
TEST(Surfaces, Mirror)
{
  SphereSurface dome;
  dome.Radius = 4;
  const SphereMirror mirror{ vec3(0, -0.5, -2), 0.5 };
  const Projector projector = Straight(vec3(0, 0, 0), vec3(0, -0.2, -1));
  const Table table = CastTable(projector, dome, 64, 32, mirror);
  SphereSurface ball;
  ball.Center = mirror.Center;
  ball.Radius = mirror.Radius;
  int lit = 0;
  for (std::size_t i = 0; i < table.Count(); i++)
  {
    const vec2 uv((double(i % 64) + 0.5) / 64, (double(i / 64) + 0.5) / 32);
    const vec3 ray = projector.Rotation * projector.Lens(uv);
    const double distance = ball.Meet(projector.Position, ray);
    EXPECT_EQ(std::isnan(table.Values[i].x), distance == Surface::Nowhere);
    if (distance < Surface::Nowhere)
    {
      lit++;
      const vec3 at = projector.Position + distance * ray;
      const vec3 normal = glm::normalize(at - mirror.Center);
      const vec3 on = glm::normalize(table.Values[i] - at);
      EXPECT_NEAR(glm::dot(on, normal), -glm::dot(ray, normal), Rounding);
      EXPECT_NEAR(glm::dot(glm::cross(ray, normal), on), 0, Rounding);
      EXPECT_NEAR(glm::length(table.Values[i]), 4, Rounding);
    }
  }
  EXPECT_GT(lit, 50);
}

// A calibrated lens: its rays are distorted to where they came from, by OpenCV's formula.
TEST(Surfaces, CameraLens)
{
  CameraLens lens;
  lens.Size = vec2(1920, 1200);
  lens.Focal = vec2(2000, 2010);
  lens.Axis = vec2(950, 900);
  lens.Distortion = { { -0.12, 0.05, 1e-3, -2e-3, 0.01 } };
  for (int i = 0; i < 100; i++)
  {
    const vec2 uv((i % 10 + 0.5) / 10, (double(i / 10) + 0.5) / 10);
    const vec3 ray = lens(uv);
    const double x = ray.x / -ray.z;
    const double y = -ray.y / -ray.z;
    const double r2 = x * x + y * y;
    const double radial = 1 - 0.12 * r2 + 0.05 * r2 * r2 + 0.01 * r2 * r2 * r2;
    const vec2 bent(x * radial + 2e-3 * x * y - 2e-3 * (r2 + 2 * x * x),
      y * radial + 1e-3 * (r2 + 2 * y * y) - 4e-3 * x * y);
    const vec2 pixel = bent * lens.Focal + lens.Axis;
    EXPECT_NEAR(pixel.x, uv.x * 1920 - 0.5, 1e-6);
    EXPECT_NEAR(pixel.y, (1 - uv.y) * 1200 - 0.5, 1e-6);
  }
  lens.Distortion = { { -2, 0, 0, 0, 0 } };
  EXPECT_TRUE(std::isnan(lens(vec2(0, 0)).x)); // beyond where it folds
}
