// SPDX-License-Identifier: BSD-3-Clause
// Props so far away that both eyes see them alike.
#include "EyesAtOnceScene.h"

#include "vtkMath.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

using namespace eyes;

namespace
{
// Scene units: half the distance between the eyes of the scene.
constexpr double EyesRadius = 0.1;

// Of an equirectangular picture that is 200 pixels wide, a radian.
const double PixelsPerRadian = 100 / vtkMath::Pi();

// Where the parallax of a point, from the middle between the eyes, is so many pixels.
double DistanceOf(double pixels)
{
  return EyesRadius / std::sin(pixels / PixelsPerRadian);
}

// Factor: so much farther away it is sure to be known, for the bound is no larger.
constexpr double Bound = 2;

struct FarScene : EyesScene
{
  explicit FarScene(const char* projection, const char* model = "omnidirectional")
    : EyesScene(projection, model)
  {
    this->Pass()->SetTechnique(vtkWideFoVPass::AUTO);
    this->Pass()->SetEyesAtOnce(vtkWideFoVPass::NEVER);
    this->Pass()->SetSortWhileMoving(true);
  }

  int CountFar() { return this->Draw().at(0).Far; }
};

void ExpectAlike(const Seen& a, const Seen& b)
{
  EXPECT_EQ(a.Colors, b.Colors);
  EXPECT_EQ(a.Depths, b.Depths);
}
}

// To the bit, and as it is without stereo.
TEST(Far, IsSeenByBothEyesAlike)
{
  for (const char* projection :
    { "equirectangular", "hammer", "azimuthal-equidistant", "equi-angular-cubemap" })
  {
    SCOPED_TRACE(projection);
    FarScene scene(projection);
    scene.AddBall(2000, 900);
    scene.AddBall(2500, 1200);
    scene.Camera->SetClipRadii(1, 10000);
    const std::vector<Seen> eyes = scene.Draw();
    ASSERT_EQ(eyes.size(), 2u);
    EXPECT_EQ(eyes[0].Far, 2);
    EXPECT_EQ(eyes[1].Far, 2);
    EXPECT_GT(eyes[0].PlainDraws, 0); // chords, as without stereo
    ExpectAlike(eyes[0], eyes[1]);
    scene.Camera->SetStereoModel("mono");
    const std::vector<Seen> mono = scene.Draw();
    EXPECT_EQ(mono.at(0).Far, 0);
    EXPECT_EQ(mono.at(0).PlainDraws, eyes[0].PlainDraws);
    ExpectAlike(eyes[0], mono.at(0));
    const auto drawn = [](float depth) { return depth < 1; };
    EXPECT_TRUE(std::any_of(eyes[0].Depths.begin(), eyes[0].Depths.end(), drawn));
  }
}

// What is at hand is not, and what comes near is no longer.
TEST(Far, IsWhatIsFarAway)
{
  FarScene scene("equirectangular");
  vtkActor* const ball = scene.AddBall(DistanceOf(0.02) * Bound, 8);
  scene.AddRing();
  const Seen far = scene.Draw().at(0);
  EXPECT_EQ(far.Far, 1);
  EXPECT_NE(scene.Pass()->GetStatistics().find("too far away for two eyes: 1"), std::string::npos);
  scene.PlaceBall(ball, 0.99 * DistanceOf(0.02), 8);
  EXPECT_EQ(scene.CountFar(), 0);
  EXPECT_EQ(scene.Pass()->GetStatistics().find("too far"), std::string::npos);
  scene.PlaceBall(ball, DistanceOf(0.02) * Bound, 8);
  const Seen again = scene.Draw().at(0);
  EXPECT_EQ(again.Far, 1);
  ExpectAlike(far, again);
  scene.Camera->SetInterpupillaryDistance(2 * Bound * 2 * EyesRadius);
  EXPECT_EQ(scene.CountFar(), 0);
  scene.Camera->SetInterpupillaryDistance(0); // the eyes are at one place
  EXPECT_EQ(scene.CountFar(), 2);
}

// A window that asks for frames takes the tolerance for it.
TEST(Far, BeginsNearerInHaste)
{
  FarScene scene("equirectangular");
  vtkActor* const ball = scene.AddBall(DistanceOf(0.25) * Bound, 0.5);
  EXPECT_EQ(scene.CountFar(), 0);
  scene.Window->SetDesiredUpdateRate(20);
  EXPECT_EQ(scene.CountFar(), 1);
  scene.PlaceBall(ball, 0.99 * DistanceOf(0.25), 0.5);
  EXPECT_EQ(scene.CountFar(), 0);
}

// Nothing is of which the bounds do not tell, that is torn, or that is asked to be exact.
TEST(Far, IsNothingThatMayBeSeen)
{
  FarScene scene("equirectangular");
  vtkActor* const ball = scene.AddBall(1000, 300);
  EXPECT_EQ(scene.CountFar(), 1);
  ball->GetProperty()->SetRepresentationToPoints();
  ball->GetProperty()->RenderPointsAsSpheresOn();
  EXPECT_EQ(scene.CountFar(), 0);
  ball->GetProperty()->SetRepresentationToSurface();
  ball->GetProperty()->RenderPointsAsSpheresOff();
  EXPECT_EQ(scene.CountFar(), 1);
  scene.Camera->Yaw(180); // on the seam
  EXPECT_EQ(scene.CountFar(), 0);
  scene.Camera->Yaw(180);
  for (const int technique : { vtkWideFoVPass::EXACT, vtkWideFoVPass::PRECLIP })
  {
    scene.Pass()->SetTechnique(technique);
    EXPECT_EQ(scene.CountFar(), 0);
  }
  scene.Pass()->SetTechnique(vtkWideFoVPass::AUTO);
  scene.Pass()->SetTolerance(0.02);
  EXPECT_EQ(scene.CountFar(), 0);
  FarScene warped("equirectangular", "warped");
  warped.AddBall(1000, 300);
  EXPECT_EQ(warped.CountFar(), 0);
}
