// SPDX-License-Identifier: BSD-3-Clause
// Head poses at their times, and rays through screens.
#include "Options/RoomOptions.h"
#include "Text/Messages.h"
#include "Viewing/PlayedHead.h"
#include "Viewing/Room.h"

#include <vtkNew.h>
#include <vtkWideFoVScreenCamera.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace widefov;

namespace
{
// Unit vectors and places a few units away, in double.
constexpr double PoseRounding = 1e-12;

// Of seconds after a few sums.
constexpr double TimeRounding = 1e-9;

// Each pose is known by its x.
std::vector<HeadPose> PosesAt(const std::vector<double>& times)
{
  std::vector<HeadPose> poses;
  for (const double time : times)
  {
    HeadPose pose;
    pose.Time = time;
    pose.HasPosition = true;
    pose.Head.Position.x = static_cast<double>(poses.size());
    poses.push_back(pose);
  }
  return poses;
}

// The pose that is due so many seconds later, -1 for none.
double After(PlayedHead& head, double seconds)
{
  head.Advance(seconds);
  const std::optional<HeadPose> pose = head.Next();
  return pose ? pose->Head.Position.x : -1;
}
}

TEST(PlayedHead, ShowsEachPoseUntilTheTimeOfTheNext)
{
  PlayedHead head(PosesAt({ 100, 101, 105, 106 }), 0, false);
  EXPECT_EQ(After(head, 0), 0);
  EXPECT_EQ(After(head, 0.5), 0);
  EXPECT_NEAR(*head.GetPause(), 0.5, TimeRounding);
  EXPECT_EQ(After(head, 0.75), 1);
  EXPECT_EQ(head.GetNumber(), 2u);
  EXPECT_EQ(After(head, 3.5), 1);
  EXPECT_EQ(After(head, 0.5), 2);
  EXPECT_EQ(After(head, 1), 3);
  EXPECT_NEAR(*head.GetPause(), 1.75, TimeRounding); // six seconds, three of them on average two
  EXPECT_EQ(After(head, 1.5), 3);
  EXPECT_EQ(After(head, 0.5), 0);
}

TEST(PlayedHead, LeavesOutWhatIsLate)
{
  PlayedHead head(PosesAt({ 0, 1, 2, 3 }), 0, false);
  EXPECT_EQ(After(head, 2.5), 2);
  EXPECT_EQ(After(head, 4000.125), 2);
  EXPECT_EQ(After(head, 0.5), 3);
}

TEST(PlayedHead, StaysWithTheLastPose)
{
  PlayedHead head(PosesAt({ 0, 1, 2 }), 0, true);
  EXPECT_EQ(After(head, 1), 1);
  EXPECT_EQ(After(head, 5), 2);
  EXPECT_FALSE(head.GetPause());
  EXPECT_EQ(After(head, 5), -1);
  EXPECT_EQ(head.GetNumber(), 3u);
}

TEST(PlayedHead, HasARateInThePlaceOfTimes)
{
  PlayedHead head(PosesAt({ 0, 0, -7 }), 10, false);
  EXPECT_EQ(After(head, 0.05), 0);
  EXPECT_EQ(After(head, 0.1), 1);
  EXPECT_EQ(After(head, 0.1), 2);
  EXPECT_NEAR(*head.GetPause(), 0.05, TimeRounding);
  EXPECT_EQ(After(head, 0.1), 0);
}

TEST(PlayedHead, OfOnePoseIsStill)
{
  for (const bool once : { false, true })
  {
    PlayedHead head(PosesAt({ 7 }), 0, once);
    EXPECT_EQ(After(head, 0), 0);
    EXPECT_FALSE(head.GetPause());
    EXPECT_EQ(After(head, 1e9), -1);
  }
}

TEST(PlayedHead, RefusesTimesThatCannotBePlayed)
{
  EXPECT_THROW(PlayedHead(PosesAt({ 0, 2, 1 }), 0, false), Failure);
  EXPECT_THROW(PlayedHead(PosesAt({ 3, 3, 3 }), 0, false), Failure);
  EXPECT_THROW(PlayedHead(PosesAt({ -1.7e308, 1.7e308 }), 0, false), Failure);
  EXPECT_NO_THROW(PlayedHead(PosesAt({ 0, 0, 1 }), 0, false));
}

// Of a room whose eye and axes are the world's.
TEST(Room, RaysAreThoseOfTheCamera)
{
  Options sight;
  sight.Projection = "perspective";
  sight.Screen = NamedScreen{ "Left", { { -3, -1, 1 }, { -1, -1, -2 }, { -1, 2, -2 } }, {} };
  sight.Head = HeadPose();
  sight.Head->HasPosition = true;
  sight.Head->Head.Position = { 0.3, 0.2, -0.1 };
  sight.Head->Head.Turn = { { 0.1, 0.3, 0, 0.9 } }; // of no effect before a screen
  vtkNew<vtkWideFoVScreenCamera> camera;
  camera->SetPosition(0, 0, 0);
  camera->SetFocalPoint(0, 0, -1);
  const wfv::Screen& s = sight.Screen->Corners;
  camera->SetScreen(&s.LowerLeft.x, &s.LowerRight.x, &s.UpperRight.x);
  camera->SetHeadPosition(0.3, 0.2, -0.1);
  for (const double x : { -1., -0.2, 0.7, 1.5 })
  {
    const double ndc[2] = { x, 0.3 - x };
    double origin[3];
    double direction[3];
    ASSERT_TRUE(camera->NDCToRay(ndc, 1, origin, direction));
    const std::optional<Vector3> ray = RayOf(sight, ndc[0], ndc[1]);
    ASSERT_TRUE(ray);
    for (std::size_t i = 0; i < 3; i++)
    {
      EXPECT_NEAR((*ray)[i], direction[i], PoseRounding);
    }
  }
}

TEST(Room, GrowsRoundAPlaceThatStays)
{
  Options o;
  o.RoomScale = 4;
  o.View.Stereo.InterpupillaryDistance = 0.2;
  const Vector3 center{ { 1, 2, 3 } };
  Vector3 eye{ { 5, 0, 3 } };
  ScaleRoom(o, eye, center, 0.5);
  EXPECT_EQ(o.RoomScale, 2);
  EXPECT_EQ(o.View.Stereo.InterpupillaryDistance, 0.1);
  EXPECT_EQ(eye, (Vector3{ { 3, 1, 3 } })); // in the room's unit as far from the centre as before
  ScaleRoom(o, eye, center, 1e-30);
  EXPECT_EQ(o.RoomScale, 1 / LargestRoomScale);
}
