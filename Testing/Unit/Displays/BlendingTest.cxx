// SPDX-License-Identifier: BSD-3-Clause
// The light of all projectors, added up on the surface.
#include "Displays/Blending.h"
#include "Displays/Projector.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace wfv;
using namespace wfv::displays;

namespace
{
// Largest deviation from even light: a step of 8 bits, as a fraction of white.
constexpr double Even = 1. / 255;

// Pixels from the edge of all pictures together: the rim, where several of them end at once, and
// shares change more from pixel to pixel than the bilinear light of pixels follows.
constexpr double Rim = 12;

constexpr int Width = 288;
constexpr int Height = 180;

// Returns the place of a point in the picture of a projector without distortion, pixels from the
// centre of the lower left pixel.
vec2 PlaceIn(const Projector& projector, double throwRatio, const vec3& point)
{
  const vec3 p = glm::transpose(projector.Rotation) * (point - projector.Position);
  const double aspect = double(Width) / Height;
  const vec2 uv(0.5 + throwRatio * p.x / -p.z, 0.5 + throwRatio * aspect * p.y / -p.z);
  return p.z < 0 ? uv * vec2(Width, Height) - 0.5 : vec2(-10);
}

struct Room
{
  std::vector<Projector> Projectors;
  std::vector<Table> Tables;
  double ThrowRatio;

  // Linear light of a place for a flat picture, and by how many pixels it is within some picture.
  vec2 LightAt(const vec3& point, double value, const std::vector<double>& black) const
  {
    double light = 0;
    double within = -1;
    for (std::size_t i = 0; i < this->Tables.size(); i++)
    {
      const vec2 at = PlaceIn(this->Projectors[i], this->ThrowRatio, point);
      const double x = std::min(at.x + 0.5, Width - 0.5 - at.x);
      const double y = std::min(at.y + 0.5, Height - 0.5 - at.y);
      within = std::max(within, std::min(x, y));
      if (std::min(x, y) > 0)
      {
        const Table& table = this->Tables[i];
        const double sent =
          Sample(table.Brightness, at) * value + (table.Lift.empty() ? 0 : Sample(table.Lift, at));
        light += black[i] + (1 - black[i]) * sent;
      }
    }
    return vec2(light, within);
  }

  static double Sample(const std::vector<float>& values, vec2 at)
  {
    const double x = std::clamp(at.x, 0., Width - 1.);
    const double y = std::clamp(at.y, 0., Height - 1.);
    const int x0 = std::min(static_cast<int>(x), Width - 2);
    const int y0 = std::min(static_cast<int>(y), Height - 2);
    const float* const p = &values[static_cast<std::size_t>(y0) * Width + x0];
    const double lower = glm::mix(double(p[0]), double(p[1]), x - x0);
    return glm::mix(lower, glm::mix(double(p[Width]), double(p[Width + 1]), x - x0), y - y0);
  }
};

// Six projectors on a ring below a dome's rim, each lighting the other side of it.
Room DomeOfSix()
{
  SphereSurface dome;
  dome.Radius = 5;
  Room room;
  room.ThrowRatio = 0.75;
  for (int i = 0; i < 6; i++)
  {
    const double angle = 2 * WFV_PI * i / 6;
    Projector projector;
    projector.Position = vec3(2 * std::sin(angle), -0.5, 2 * std::cos(angle));
    projector.Rotation = LookAlong(vec3(-std::sin(angle), 1, -std::cos(angle)), vec3(0, 1, 0));
    projector.Lens = ThrowLens(room.ThrowRatio, double(Width) / Height, vec2(0));
    room.Projectors.push_back(projector);
    room.Tables.push_back(CastTable(projector, dome, Width, Height));
  }
  return room;
}

// Points all over the upper part of the dome.
template <typename Visit>
void VisitDome(const Visit& visit)
{
  for (int i = 0; i < 20000; i++)
  {
    const double y = 0.999 * (i + 0.5) / 20000; // a spiral of even density
    const double angle = 2.399963229728653 * i;
    const double r = std::sqrt(1 - y * y);
    visit(5. * vec3(r * std::cos(angle), y, r * std::sin(angle)));
  }
}
}

TEST(Blending, DomeOfSixIsEven)
{
  Room room = DomeOfSix();
  const std::vector<double> black(6, 0);
  Blend(room.Tables, black, vec3(0));
  double least = 2;
  double most = 0;
  int places = 0;
  VisitDome([&](const vec3& point) {
    const vec2 light = room.LightAt(point, 1, black);
    if (light.y > Rim)
    {
      least = std::min(least, light.x);
      most = std::max(most, light.x);
      places++;
    }
  });
  EXPECT_GT(places, 10000);
  EXPECT_GT(least, 1 - Even);
  EXPECT_LT(most, 1 + Even);
}

// Black and grey are as even as white, wherever one, two or three of them overlap.
TEST(Blending, BlackIsLifted)
{
  Room room = DomeOfSix();
  const std::vector<double> black{ 0.01, 0.02, 0.01, 0.02, 0.01, 0.015 };
  Blend(room.Tables, black, vec3(0));
  for (const double value : { 0., 0.5, 1. })
  {
    std::vector<double> lights;
    VisitDome([&](const vec3& point) {
      const vec2 light = room.LightAt(point, value, black);
      if (light.y > Rim)
      {
        lights.push_back(light.x);
      }
    });
    // (on a border of a picture the black of a pixel begins at once, and its lift beside it: those
    // pixels are left out)
    std::sort(lights.begin(), lights.end());
    const std::size_t few = lights.size() / 20;
    EXPECT_LT(lights[lights.size() - 1 - few] - lights[few], Even) << value;
  }
}

// Two pictures side by side that share a fifth: a ramp that grows steadily, and halves in the
// middle.
TEST(Blending, RampOfTwo)
{
  PlaneSurface wall;
  wall.LowerLeft = vec3(-50, -50, -4);
  wall.LowerRight = vec3(50, -50, -4);
  wall.UpperRight = vec3(50, 50, -4);
  std::vector<Table> tables;
  for (const double x : { -1.6, 1.6 })
  {
    Projector projector;
    projector.Position = vec3(x, 0, 0);
    projector.Lens = ThrowLens(1, double(Width) / Height, vec2(0));
    tables.push_back(CastTable(projector, wall, Width, Height));
  }
  Blend(tables, { 0, 0 }, vec3(0));
  const std::size_t row = std::size_t{ Width } * (Height / 2);
  for (int x = 1; x < Width; x++)
  {
    EXPECT_LE(tables[0].Brightness[row + x], tables[0].Brightness[row + x - 1] + 1e-6f);
  }
  EXPECT_EQ(tables[0].Brightness[row], 1);
  const double middle = Width * (0.5 + 1.6 / 4) - 0.5; // pixel of the wall's middle
  const auto at = static_cast<std::size_t>(middle);
  const double mixed = glm::mix(double(tables[0].Brightness[row + at]),
    double(tables[0].Brightness[row + at + 1]), middle - double(at));
  EXPECT_NEAR(mixed, 0.5, 0.01);
  EXPECT_LT(tables[0].Brightness[row + Width - 1], 0.01);
}

// Projectors on both sides of a ball light different parts of it, in the same directions.
TEST(Blending, HiddenPartsDoNotOverlap)
{
  SphereSurface ball;
  ball.Radius = 1;
  std::vector<Table> tables;
  for (const double z : { 4., -4. })
  {
    Projector projector;
    projector.Position = vec3(0, 0, z);
    projector.Rotation = LookAlong(vec3(0, 0, -z), vec3(0, 1, 0));
    projector.Lens = ThrowLens(1.5, double(Width) / Height, vec2(0));
    tables.push_back(CastTable(projector, ball, Width, Height));
  }
  Blend(tables, { 0, 0 }, vec3(0, 0, 10));
  const std::size_t middle = std::size_t{ Width } * (Height / 2) + Width / 2;
  EXPECT_EQ(tables[0].Brightness[middle], 1);
  EXPECT_EQ(tables[1].Brightness[middle], 1);
}

// A projector's gamma turns the values that it gets back into the wanted light.
TEST(Blending, GammaIsUndone)
{
  for (const double gamma : { 1., 1.8, 2.2, 2.6 })
  {
    const double sent = Lit(0.5, 0.3, 0.01, gamma);
    EXPECT_NEAR(std::pow(sent, gamma), 0.3 * std::pow(0.5, gamma) + 0.01, 1e-12);
    EXPECT_EQ(Lit(1, 1, 0, gamma), 1);
    EXPECT_EQ(Lit(0, 1, 0, gamma), 0);
  }
}
