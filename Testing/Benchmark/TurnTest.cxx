// SPDX-License-Identifier: BSD-3-Clause
// Cameras that move before each frame: the pictures of the benchmark really turn, those of every
// method by the same angle to the same side, and a film's are what each of its places shows.
#include "BenchStage.h"
#include "System/Display.h"
#include "Plan.h"

#include <vtkCamera.h>
#include <vtkNew.h>
#include <vtkUnsignedCharArray.h>

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

using namespace wfv;
using namespace wfv::bench;

namespace
{
// Between tests, when none has a window.
class KeepsDisplay : public testing::Environment
{
public:
  void SetUp() override { this->Display = std::make_unique<widefov::DisplayConnection>(); }
  void TearDown() override { this->Display.reset(); }

private:
  std::unique_ptr<widefov::DisplayConnection> Display;
};
const testing::Environment* const TheDisplay = testing::AddGlobalTestEnvironment(new KeepsDisplay);

constexpr int Width = 128;
constexpr int Height = 64;

// A quarter: the faces of the cubemap then change places, and columns move by whole pixels.
constexpr double Quarter = 90;

// Of the pixels. A camera that was turned is rounded, and borders may pass a pixel's centre.
constexpr double MostMoved = 0.001;

// Of the pixels, those that show something else after one, two or three quarters.
constexpr double LeastTurned = 0.25;

// Of the pixels, those that show something else one frame of a film later, half a pixel on or so.
constexpr double LeastFilmed = 0.01;

std::vector<bench::Run> PlanOf(
  const bench::Motion& motion, const widefov::Options& camera = widefov::Options())
{
  PlanRequest request;
  request.Quick = true;
  request.Size = { { Width, Height } };
  request.Methods = { "auto", "exact", "preclip", "vertex", "perspective", "cubemap" };
  request.Motion = motion;
  return MakePlan(request, camera);
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
  BenchStage still(scene, PlanOf({ Mode::Still, 0 }));
  BenchStage turning(scene, PlanOf({ Mode::Turn, Quarter }));
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

namespace
{
// Where a camera of the scene is for that frame, as a camera that stands there.
widefov::Options CameraAt(const BenchScene& scene, const bench::Motion& motion, int frame)
{
  double b[6];
  widefov::SceneBounds(scene.Scene, b);
  const double diagonal = std::hypot(b[1] - b[0], b[3] - b[2], b[5] - b[4]);
  const widefov::Pose start = widefov::MakePose(scene.Scene, scene.Camera);
  const widefov::Pose pose = PoseAt(start, CircleShare * diagonal, motion, frame);
  widefov::Options camera = scene.Camera;
  camera.Eye = pose.Eye;
  camera.Direction = pose.Direction;
  camera.Up = pose.Up;
  return camera;
}

struct Moved
{
  bench::Motion Motion;
  double Least; // of the pixels, those that show something else in the next frame
};
const std::vector<Moved> Moves{ { { Mode::Film, 0 }, LeastFilmed },
  { { Mode::First, 0 }, LeastTurned } };
}

TEST(BenchFilm, PicturesAreThoseOfCamerasThatStandThere)
{
  const BenchScene scene = LoadBenchScene("cornell", "");
  for (const Moved& moves : Moves)
  {
    BenchStage moving(scene, PlanOf(moves.Motion));
    std::vector<std::vector<int>> last(moving.GetEntries().size());
    for (int frame = 1; frame <= 3; ++frame)
    {
      const widefov::Options camera = CameraAt(scene, moves.Motion, frame);
      BenchStage still(scene, PlanOf({ Mode::Still, 0 }, camera));
      for (std::size_t i = 0; i < last.size(); ++i)
      {
        const std::string name = NameOf(moves.Motion.Mode) + " " +
          NameOf(moving.GetEntries()[i].Run) + ", frame " + std::to_string(frame);
        const std::vector<int> colors = ColorsOf(moving, moving.GetEntries()[i]);
        EXPECT_LE(Differing(colors, ColorsOf(still, still.GetEntries()[i]), 0), MostMoved) << name;
        EXPECT_TRUE(frame == 1 || Differing(colors, last[i], 0) >= moves.Least) << name;
        last[i] = colors;
      }
    }
  }
}
