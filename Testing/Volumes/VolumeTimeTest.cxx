// SPDX-License-Identifier: BSD-3-Clause
// Processor time of a volume beside that of stock VTK's perspective, for as many rays that hit it.
#include "VolumeCheck.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <iostream>

using namespace wfv;
using namespace wfv::test;

namespace
{
// Times stock VTK's.
constexpr double MostTime = 1.5;

// Of each picture, in turns; the least time of them counts.
constexpr int Frames = 5;

// A picture in which every ray meets the volume.
Shot Full(const char* projection, bool inside)
{
  Shot shot = ShotOf(projection, true);
  shot.Width = 256;
  shot.Height = 128;
  if (shot.Projection == "perspective")
  {
    shot.Options.HorizontalFov = 50;
    shot.Options.VerticalFov = 26;
    shot.Eye = inside ? shot.Eye : vec3(0, 0, 30);
    shot.Direction = vec3(0, 0, -1);
  }
  return shot;
}

// Seconds of processor time of one frame of each.
struct Times
{
  double Stock = 1e30;
  double Ours = 1e30;
};

double TimeOf(VolumeScene& scene, const Shot& shot, bool stock)
{
  scene.Stock = stock;
  scene.Draw(shot); // builds what it has to
  const std::clock_t before = std::clock();
  scene.Window->Render();
  return double(std::clock() - before) / CLOCKS_PER_SEC;
}

void CheckTime(const char* projection, bool inside)
{
  VolumeScene stock(Wavelet());
  VolumeScene ours(Wavelet());
  for (VolumeScene* scene : { &stock, &ours })
  {
    // thin: no ray ends early
    scene->SetFunctions(scene->March.Range[0], scene->March.Range[1], 0.01);
    scene->March.Step = 0.1;
    scene->Mapper->SetSampleDistance(0.1f);
  }
  Times times;
  for (int i = 0; i < Frames; i++)
  {
    times.Stock = std::min(times.Stock, TimeOf(stock, Full("perspective", inside), true));
    times.Ours = std::min(times.Ours, TimeOf(ours, Full(projection, inside), false));
  }
  const double seen = ours.Compare().Seen / stock.Compare().Seen;
  char row[200];
  std::snprintf(row, sizeof row,
    "%-22s %-8s %.1f ms, stock perspective %.1f ms, %.3f times the rays: ratio %.2f", projection,
    inside ? "inside" : "outside", 1000 * times.Ours, 1000 * times.Stock, seen,
    times.Ours / times.Stock / seen);
  std::cout << row << std::endl;
  EXPECT_LE(times.Ours / times.Stock / seen, MostTime) << row;
}
}

TEST(VolumeTime, TheSameRays)
{
  CheckTime("perspective", false);
  CheckTime("perspective", true);
}

TEST(VolumeTime, AsManyRays)
{
  CheckTime("equirectangular", true);
  CheckTime("hammer", true);
}
