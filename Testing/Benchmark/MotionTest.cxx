// SPDX-License-Identifier: BSD-3-Clause
// Where cameras of the benchmark go.
#include "Motion.h"
#include "Projections/Projection.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace wfv;
using namespace wfv::bench;

namespace
{
constexpr double Radius = 3;

double Distance(const widefov::Vector3& a, const widefov::Vector3& b)
{
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

// Up is not at right angles to the direction, and is no axis.
widefov::Pose PoseOf(Mode mode, int frame)
{
  const widefov::Pose start{ { { 1, 2, 3 } }, { { 0, 0.6, -0.8 } }, { { 0.6, 0.8, 0 } } };
  return PoseAt(start, Radius, { mode, 1 }, frame);
}
}

TEST(BenchMotion, FilmsMoveAndTurnBeforeEachFrame)
{
  for (int frame = 1; frame < 100; ++frame)
  {
    const widefov::Pose a = PoseOf(Mode::Film, frame);
    const widefov::Pose b = PoseOf(Mode::Film, frame + 1);
    EXPECT_NEAR(Distance(a.Eye, PoseOf(Mode::Still, 0).Eye), Radius, 1e-12);
    EXPECT_NEAR(Distance(a.Eye, b.Eye), 2 * Radius * std::sin(3 * WFV_PI / 180), 1e-12);
    EXPECT_GT(Distance(a.Direction, b.Direction), 0.01);
    EXPECT_LT(Distance(a.Direction, b.Direction), 0.02);
    EXPECT_EQ(a.Up, b.Up);
    EXPECT_EQ(a.Eye, PoseOf(Mode::Film, frame).Eye); // again, the same
  }
}

TEST(BenchMotion, FirstFramesAreFarFromTheLastAndNowhereTwice)
{
  for (int frame = 2; frame < 100; ++frame)
  {
    const widefov::Pose here = PoseOf(Mode::First, frame);
    const widefov::Pose last = PoseOf(Mode::First, frame - 1);
    EXPECT_GT(Distance(here.Eye, last.Eye), Radius) << frame;
    EXPECT_GT(Distance(here.Direction, last.Direction), 1) << frame;
    for (int before = 1; before < frame; ++before)
    {
      EXPECT_GT(Distance(here.Eye, PoseOf(Mode::First, before).Eye), 0.01 * Radius);
    }
  }
}

TEST(BenchMotion, TurnsKeepThePlace)
{
  const widefov::Pose start = PoseOf(Mode::Still, 7);
  EXPECT_EQ(PoseOf(Mode::Turn, 7).Eye, start.Eye);
  EXPECT_GT(Distance(PoseOf(Mode::Turn, 7).Direction, start.Direction), 0.05);
  EXPECT_LT(Distance(PoseOf(Mode::Turn, 360).Direction, start.Direction), 1e-12);
}
