// SPDX-License-Identifier: BSD-3-Clause
// The farthest depth of a part of a picture, against looking at every pixel.
#include "vtkWideFoVDepthPicture.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

using namespace wfv;

namespace
{
// Of the pixels that a rectangle meets; 0 where there is none.
double LookAtAll(const std::vector<float>& depths, int width, int height, vec2 low, vec2 high)
{
  double farthest = 0;
  for (int y = 0; y < height; y++)
  {
    for (int x = 0; x < width; x++)
    {
      const bool meets = x <= high.x && x + 1 > low.x && y <= high.y && y + 1 > low.y;
      farthest = meets ? std::max<double>(farthest, depths[y * width + x]) : farthest;
    }
  }
  return farthest;
}

DepthPicture Make(int width, int height, const std::vector<float>& depths)
{
  DepthPicture picture;
  picture.Take(width, height, depths);
  return picture;
}
}

RC_GTEST_PROP(DepthPicture, MissesNoPixel, ())
{
  const int width = *rc::gen::inRange(1, 40);
  const int height = *rc::gen::inRange(1, 40);
  const auto steps =
    *rc::gen::container<std::vector<int>>(width * height, rc::gen::inRange(0, 101));
  std::vector<float> depths(steps.size());
  std::transform(steps.begin(), steps.end(), depths.begin(), [](int s) { return s / 100.0f; });
  const auto place = [] { return *rc::gen::inRange(-100, 500) / 10.0; };
  const vec2 low(place(), place());
  const vec2 high = low + vec2(*rc::gen::inRange(0, 300), *rc::gen::inRange(0, 300)) / 10.0;
  const double all = LookAtAll(depths, width, height, low, high);
  const double found = Make(width, height, depths).GetFarthest(low, high);
  RC_ASSERT(found >= all);
  // blocks are no larger than a part of the rectangle
  const vec2 wider = high - low + 2.0;
  RC_ASSERT(found <= LookAtAll(depths, width, height, low - wider, high + wider));
}

TEST(DepthPicture, SaysNothingOfWhatIsNoNumber)
{
  const DepthPicture picture = Make(2, 1, { 0.25f, 0.5f });
  EXPECT_EQ(picture.GetFarthest(vec2(0.5), vec2(0.75)), 0.25);
  EXPECT_EQ(picture.GetFarthest(vec2(0.5), vec2(1.5, 0.75)), 0.5);
  EXPECT_EQ(picture.GetFarthest(vec2(2, 0), vec2(3, 1)), 0);
  EXPECT_EQ(picture.GetFarthest(vec2(std::nan(""), 0), vec2(1)), 1);
  EXPECT_EQ(picture.GetFarthest(vec2(0), vec2(std::numeric_limits<double>::infinity())), 1);
  EXPECT_EQ(DepthPicture().GetFarthest(vec2(0), vec2(1)), 1);
}
