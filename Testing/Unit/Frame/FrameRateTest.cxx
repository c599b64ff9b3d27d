// SPDX-License-Identifier: BSD-3-Clause
// By how much frames give way, where what each level takes is known.
#include "Frame/FrameRate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

namespace
{
using Costs = std::array<double, wfv::FrameRate::Levels>; // seconds of a frame
constexpr double Share = 0.1;
constexpr double Standing = 0.5; // of a frame that stands, and has no share
const wfv::FrameRate::Allowed All{ { true, true, true, true, true } };

// Levels of a motion of so many frames, after a frame that stood.
std::vector<int> Move(wfv::FrameRate& rate, const Costs& costs, int frames = 24,
  const wfv::FrameRate::Allowed& allowed = All, double stood = Standing)
{
  rate.Stand();
  std::vector<int> levels;
  double took = stood;
  for (int i = 0; i < frames; i++)
  {
    levels.push_back(rate.Move(took, Share, allowed));
    took = costs[levels.back()];
  }
  return levels;
}

int CountChanges(const std::vector<int>& levels)
{
  int changes = 0;
  for (std::size_t i = 1; i < levels.size(); i++)
  {
    changes += levels[i] != levels[i - 1];
  }
  return changes;
}
}

TEST(FrameRate, GivesWayUntilTheShareIsKept)
{
  wfv::FrameRate rate;
  const Costs costs{ { 0.5, 0.3, 0.09, 0.05, 0.03 } };
  const std::vector<int> levels = Move(rate, costs);
  EXPECT_EQ(levels.front(), 0);
  EXPECT_EQ(levels.back(), 2);
  EXPECT_EQ(CountChanges(levels), 2);
  // and the next motion begins there
  EXPECT_EQ(Move(rate, costs), std::vector<int>(24, 2));
}

TEST(FrameRate, WhatSavesNothingIsGivenUp)
{
  wfv::FrameRate rate;
  // most of it is the same whatever the size
  const std::vector<int> levels = Move(rate, { { 1.2, 0.5, 0.48, 0.47, 0.47 } });
  EXPECT_EQ(levels.back(), 1);
  EXPECT_EQ(*std::max_element(levels.begin(), levels.end()), 2);
  EXPECT_EQ(CountChanges(levels), 3); // 0, 1, 2, 1
}

TEST(FrameRate, NoDearerLevelStays)
{
  wfv::FrameRate rate;
  EXPECT_EQ(Move(rate, { { 0.2, 0.25, 0.3, 0.3, 0.3 } }).back(), 0);
  EXPECT_EQ(Move(rate, { { 0.2, 0.25, 0.3, 0.3, 0.3 } }).back(), 0);
}

TEST(FrameRate, DoesNotFlickerBetweenTwo)
{
  wfv::FrameRate rate;
  // the second leaves much time, the first takes too long
  const std::vector<int> levels = Move(rate, { { 0.15, 0.04, 0.03, 0.02, 0.02 } });
  EXPECT_EQ(levels.back(), 1);
  EXPECT_EQ(CountChanges(levels), 1);
}

TEST(FrameRate, WithTimeToSpareGoesBack)
{
  wfv::FrameRate rate;
  EXPECT_EQ(Move(rate, { { 0.9, 0.6, 0.4, 0.3, 0.2 } }).back(), 4);
  const Costs light{ { 0.02, 0.01, 0.01, 0.01, 0.01 } };
  EXPECT_EQ(Move(rate, light).back(), 0);
  // a frame that stood within the share: one that moves begins as sharp
  EXPECT_EQ(Move(rate, light, 1, All, 0.02).back(), 0);
}

TEST(FrameRate, KeepsToWhatIsAllowed)
{
  wfv::FrameRate rate;
  const Costs costs{ { 0.9, 0.6, 0.4, 0.3, 0.2 } };
  for (const int level : Move(rate, costs, 24, { { true, false, true, false, false } }))
  {
    EXPECT_TRUE(level == 0 || level == 2);
  }
  for (const int level : Move(rate, costs, 24, { { false, false, false, true, false } }))
  {
    EXPECT_EQ(level, 3);
  }
}
