// SPDX-License-Identifier: BSD-3-Clause
// A camera that turns before each frame: the pictures of the benchmark really turn, those of
// every method by the same angle to the same side.
#include "BenchStage.h"
#include "CellPictures.h"
#include "Plan.h"

#include <vtkCamera.h>
#include <vtkNew.h>
#include <vtkUnsignedCharArray.h>

#include <gtest/gtest.h>

using namespace wfv;
using namespace wfv::bench;

namespace
{
constexpr int Width = 128;
constexpr int Height = 64;

// A quarter: the faces of the cubemap then change places, and columns move by whole pixels.
constexpr double Quarter = 90;

// Of the pixels. A camera that was turned is rounded, and borders may pass a pixel's centre.
constexpr double MostMoved = 0.001;

// Of the pixels, those that show something else after one, two or three quarters.
constexpr double LeastTurned = 0.25;

std::vector<bench::Run> PlanOf(double turn)
{
  PlanRequest request;
  request.Quick = true;
  request.Size = { { Width, Height } };
  request.Methods = { "auto", "exact", "tessellate", "preclip", "vertex", "perspective",
    "cubemap" };
  request.Motion = { turn == 0 ? Mode::Still : Mode::Turn, turn };
  return MakePlan(request, widefov::Options());
}

// Colours, rows from the bottom.
std::vector<int> ColorsOf(BenchStage& stage, BenchEntry& entry)
{
  stage.Draw(entry);
  vtkNew<vtkUnsignedCharArray> pixels;
  entry.Window->GetPixelData(0, 0, Width - 1, Height - 1, 0, pixels);
  std::vector<int> colors;
  for (vtkIdType n = 0; n < pixels->GetNumberOfTuples(); ++n)
  {
    const unsigned char* rgb = pixels->GetPointer(3 * n);
    colors.push_back((rgb[0] << 16) + (rgb[1] << 8) + rgb[2]);
  }
  return colors;
}

// The share of pixels of one picture that differ from those of the other so many columns on.
double Differing(const std::vector<int>& a, const std::vector<int>& b, int columns)
{
  long differing = 0;
  for (int n = 0; n < Width * Height; ++n)
  {
    const int column = (n % Width + columns + Width) % Width;
    differing += a[n] != b[n / Width * Width + column];
  }
  return double(differing) / (Width * Height);
}
}

TEST(BenchTurn, PicturesOfEveryMethodTurn)
{
  const BenchScene scene = LoadBenchScene("room", "");
  BenchStage still(scene, PlanOf(0));
  BenchStage turning(scene, PlanOf(Quarter));
  for (std::size_t i = 0; i < still.GetEntries().size(); ++i)
  {
    BenchEntry& entry = turning.GetEntries()[i];
    const std::string name = NameOf(entry.Run);
    const std::vector<int> before = ColorsOf(still, still.GetEntries()[i]);
    EXPECT_EQ(ColorsOf(still, still.GetEntries()[i]), before) << name;
    // of a perspective, and where a triangle is not cut at the seam, columns do not move alike
    const bool columns = name != "perspective" && name != "vertex";
    for (int turns = 1; turns <= 4; ++turns)
    {
      const std::vector<int> after = ColorsOf(turning, entry);
      // counterclockwise, seen from above: what is seen moves to the right
      const double moved = Differing(before, after, turns * Width / 4);
      EXPECT_TRUE(moved <= MostMoved || (turns < 4 && !columns)) << name << ", " << turns;
      EXPECT_TRUE(turns == 4 || Differing(before, after, 0) >= LeastTurned)
        << name << ", " << turns;
    }
  }
}
