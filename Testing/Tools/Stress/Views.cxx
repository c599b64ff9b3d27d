// SPDX-License-Identifier: BSD-3-Clause
#include "Views.h"

#include <vtkPolyData.h>

#include <algorithm>
#include <sstream>

namespace wfv
{
namespace stress
{
namespace
{
// So often a picture is as wide as the largest that the project promises.
constexpr int WideEvery = 25;

// The closed meshes have as many triangles as they say on average alone; so much more is
// planned that a run has what it was asked for.
constexpr double Margin = 1.05;

// Odd sizes put pixel centres exactly on the meridian ahead and on the equator.
const std::vector<std::array<int, 2>> MapSizes{ { { 256, 128 } }, { { 255, 127 } },
  { { 320, 160 } }, { { 512, 256 } }, { { 256, 256 } } };
const std::vector<std::array<int, 2>> RoundSizes{ { { 192, 192 } }, { { 191, 191 } },
  { { 256, 192 } }, { { 360, 360 } } };
const std::array<int, 2> WideMap{ { 8192, 256 } };
const std::array<int, 2> WideRound{ { 2048, 2048 } };

void SetSize(test::Shot& shot, Random& random, const Projection& p, int number)
{
  const bool round = p.Axis == Family::Azimuthal;
  const bool wide = number % WideEvery == WideEvery - 1;
  const std::array<int, 2> size =
    wide ? (round ? WideRound : WideMap) : random.Choose(round ? RoundSizes : MapSizes);
  shot.Width = size[0];
  shot.Height = size[1];
}

// Half of the views are as wide as the projection allows.
void SetFieldOfView(test::Shot& shot, Random& random, const Projection& p)
{
  const double widest = p.Axis == Family::Planar ? 120 : p.MaxHorizontalFov;
  const double fov =
    random.Chance(0.5) ? widest : random.Choose(std::vector<double>{ 30, 60, 120, 180, 270, 350 });
  ViewOptions& o = shot.Options;
  o.HorizontalFov = std::clamp(fov, p.MinHorizontalFov, widest);
  o.VerticalFov = std::clamp(o.HorizontalFov / 2, p.MinVerticalFov, p.MaxVerticalFov);
  if (p.Axis == Family::Azimuthal)
  {
    o.VerticalFov = std::min(o.HorizontalFov, p.MaxVerticalFov);
  }
  if (p.Axis == Family::Planar)
  {
    const double half = std::tan(o.HorizontalFov * WFV_PI / 360) * shot.Height / shot.Width;
    o.VerticalFov = std::min(2 * std::atan(half) * 180 / WFV_PI, p.MaxVerticalFov);
  }
  o.Aspect = double(shot.Width) / shot.Height;
}

void SetPose(test::Shot& shot, Random& random, bool upright)
{
  if (upright || random.Chance(0.2))
  {
    return;
  }
  shot.Direction = random.Direction();
  shot.Up = FrameUp(random, shot.Direction);
  shot.Options.Tilt = random.Chance(0.2) ? random.Between(-90, 90) : 0;
}
}

vec3 FrameUp(Random& random, const vec3& direction)
{
  vec3 up(0);
  do
  {
    const vec3 other = random.Direction();
    up = other - direction * glm::dot(other, direction);
  } while (glm::length(up) < 0.1);
  return glm::normalize(up);
}

Batch MakeBatch(const BatchId& id, std::uint64_t seed)
{
  const Case& c = *FindCase(id.Case);
  const Projection& p = *FindProjection(id.Projection);
  // every projection draws the same primitives, in views of its own
  Random random(seed, id.Case + " " + std::to_string(id.Number));
  Random view(seed, id.Projection + " " + id.Case + " " + std::to_string(id.Number));
  Batch batch;
  batch.Id = id;
  batch.Seed = seed;
  batch.Closed = c.Closed;
  batch.What = c.Make(random, c.Primitives);
  batch.Shot.Projection = id.Projection;
  SetSize(batch.Shot, view, p, id.Number);
  SetFieldOfView(batch.Shot, view, p);
  SetPose(batch.Shot, view, c.Upright);
  batch.Shot.Eye = batch.What.Eye;
  batch.Shot.Options.Radii = { { batch.What.Near, batch.What.Far } };
  return batch;
}

std::vector<BatchId> PlanBatches(
  const std::string& projection, const std::vector<std::string>& cases, long primitives)
{
  double shares = 0;
  for (const std::string& name : cases)
  {
    shares += FindCase(name)->Share;
  }
  std::vector<int> counts;
  for (const std::string& name : cases)
  {
    const Case& c = *FindCase(name);
    const double wanted = Margin * double(primitives) * c.Share / shares / c.Primitives;
    counts.push_back(std::max(1, int(std::ceil(wanted))));
  }
  std::vector<BatchId> plan;
  const int most = counts.empty() ? 0 : *std::max_element(counts.begin(), counts.end());
  for (int number = 0; number < most; ++number)
  {
    for (std::size_t i = 0; i < cases.size(); ++i)
    {
      if (number < counts[i])
      {
        plan.push_back({ projection, cases[i], number });
      }
    }
  }
  return plan;
}

std::string Reproducer(const Batch& batch, const std::string& technique, double tolerance)
{
  std::ostringstream pixels;
  pixels << tolerance;
  return "widefov-stress --seed " + std::to_string(batch.Seed) + " --projections " +
    batch.Id.Projection + " --technique " + technique + " --tolerance " + pixels.str() +
    " --cases " + batch.Id.Case + " --batch " + std::to_string(batch.Id.Number) +
    " --output FILE.json";
}
}
}
