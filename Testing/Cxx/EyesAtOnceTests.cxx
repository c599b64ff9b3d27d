// SPDX-License-Identifier: BSD-3-Clause
// Both eyes in one traversal of the props: what each sees is what it sees in a traversal of its
// own.
#include "EyesAtOnceScene.h"

#include "vtkActor.h"
#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkMapper.h"
#include "vtkProperty.h"
#include "vtkWideFoVRenderer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

using namespace eyes;

namespace
{
int CountChanged(const Seen& a, const Seen& b)
{
  int changed = 0;
  for (std::size_t i = 0; i < a.Depths.size(); i++)
  {
    changed += !std::equal(&a.Colors[4 * i], &a.Colors[4 * i] + 4, &b.Colors[4 * i]) ||
      a.Depths[i] != b.Depths[i];
  }
  return changed;
}

// shared: props in one traversal.
void ExpectSame(const std::vector<Seen>& once, const std::vector<Seen>& twice, int shared)
{
  ASSERT_EQ(once.size(), 2u);
  ASSERT_EQ(twice.size(), 2u);
  for (std::size_t i = 0; i < 2; i++)
  {
    EXPECT_EQ(once[i].Eye, i == 0 ? -1 : 1);
    EXPECT_EQ(once[i].Shared, shared);
    EXPECT_EQ(twice[i].Shared, 0);
    ASSERT_GT(once[i].Depths.size(), 0u);
    ASSERT_EQ(once[i].Depths.size(), twice[i].Depths.size());
    EXPECT_EQ(CountChanged(once[i], twice[i]), 0) << (i == 0 ? "left" : "right");
  }
  // it shows something, and not the same to both
  EXPECT_GT(CountChanged(once[0], once[1]), static_cast<int>(once[0].Depths.size() / 20));
}

// What draws into the layer of each eye.
bool HasLayers()
{
  WideFoVTestWindow scene("equirectangular", 20, 10);
  scene.Window->Render();
  const std::string all = scene.Window->ReportCapabilities();
  return all.find("GL_ARB_shader_viewport_layer_array") != std::string::npos;
}

class EyesAtOnce : public ::testing::Test
{
protected:
  void SetUp() override
  {
    if (!HasLayers())
    {
      GTEST_SKIP() << "this OpenGL has no GL_ARB_shader_viewport_layer_array";
    }
  }
};

const char* const Projections[] = { "equirectangular", "hammer", "azimuthal-equidistant",
  "equi-angular-cubemap" };
}

TEST_F(EyesAtOnce, ShowWhatTwoTraversalsShow)
{
  for (const char* projection : Projections)
  {
    EyesScene scene(projection, "omnidirectional");
    scene.AddRoom();
    const std::vector<Seen> once = scene.Draw();
    const std::vector<Seen> twice = scene.DrawTwice();
    SCOPED_TRACE(projection);
    ExpectSame(once, twice, 9 - once.at(0).Culled);
    EXPECT_EQ(once.at(1).Draws, 0);
    EXPECT_EQ(once.at(0).Draws, twice.at(0).Draws);
    EXPECT_EQ(twice.at(1).Draws, twice.at(0).Draws);
  }
}

// Meshes that are sorted, well and in haste.
TEST_F(EyesAtOnce, ShowSortedMeshesAsTwoTraversalsDo)
{
  for (const char* projection : Projections)
  {
    for (const int technique : { vtkWideFoVPass::EXACT, vtkWideFoVPass::AUTO })
    {
      for (const bool haste : { false, true })
      {
        SCOPED_TRACE(
          std::string(projection) + " " + std::to_string(technique) + (haste ? " in haste" : ""));
        EyesScene scene(projection, "omnidirectional");
        scene.AddRing(5); // some triangles lie between the samples of one eye alone
        scene.AddSortedRoom();
        scene.Pass()->SetTechnique(technique);
        scene.Pass()->SetSortWhileMoving(!haste);
        const std::vector<Seen> once = scene.Draw();
        const bool plain = !haste && technique == vtkWideFoVPass::AUTO;
        EXPECT_EQ(once.at(0).PlainDraws > 0, plain);
        const std::vector<Seen> twice = scene.DrawTwice();
        ExpectSame(once, twice, 2);
        EXPECT_GT(once.at(0).LeftOut, 0);
        EXPECT_LT(once.at(0).LeftOut, std::min(twice.at(0).LeftOut, twice.at(1).LeftOut));
        EXPECT_EQ(once.at(1).Draws, 0);
        EXPECT_EQ(scene.Pass()->GetNumberOfSortedMeshes(), 0); // those of the other eye serve
      }
    }
  }
}

// With what cannot be shared before, among and behind it, one sample a pixel and several.
TEST_F(EyesAtOnce, ShowTheOthersInEachTurn)
{
  for (const char* model : { "omnidirectional", "warped" })
  {
    for (const char* projection : { "equirectangular", "azimuthal-equidistant" })
    {
      for (const int samples : { 0, 4 })
      {
        SCOPED_TRACE(std::string(model) + " " + projection + " samples " + std::to_string(samples));
        EyesScene scene(projection, model, samples);
        scene.AddOthers();
        scene.AddRoom();
        scene.AddOthers();
        scene.AddRing();
        scene.Pass()->SetSortWhileMoving(true);
        const std::vector<Seen> once = scene.Draw();
        ExpectSame(once, scene.DrawTwice(), 10 - once.at(0).Culled);
        EXPECT_GT(once.at(1).Draws, 0);
        EXPECT_LT(once.at(1).Draws, once.at(0).Draws);
      }
    }
  }
}

// A circle of the eyes that fades towards the poles, a view that is tilted, and a part of a window.
TEST_F(EyesAtOnce, ShowPartsAndFades)
{
  EyesScene scene("equirectangular", "omnidirectional");
  scene.AddRoom();
  scene.AddRing();
  scene.Pass()->SetSortWhileMoving(true);
  scene.Pass()->SetTechnique(vtkWideFoVPass::AUTO);
  scene.Camera->SetTilt(20);
  scene.Camera->SetPoleFade(40, 70);
  ExpectSame(scene.Draw(), scene.DrawTwice(), 10);
  vtkNew<vtkWideFoVRenderer> beside;
  beside->SetViewport(0, 0, 0.3, 1);
  beside->SetBackground(0.4, 0, 0);
  scene.Window->AddRenderer(beside);
  scene.Renderer->SetViewport(0.3, 0.2, 1, 0.9);
  ExpectSame(scene.Draw(), scene.DrawTwice(), 10);
}

// And with what both see alike, which is drawn as it is without stereo.
TEST_F(EyesAtOnce, ShowWhatIsFarInEachTurn)
{
  for (const bool haste : { false, true })
  {
    SCOPED_TRACE(haste);
    EyesScene scene("equirectangular", "omnidirectional");
    scene.AddBall(1000, 300);
    scene.AddRing();
    scene.AddBall(1400, 400);
    scene.Pass()->SetTechnique(vtkWideFoVPass::AUTO);
    scene.Pass()->SetSortWhileMoving(!haste);
    const std::vector<Seen> once = scene.Draw();
    ExpectSame(once, scene.DrawTwice(), 1);
    EXPECT_EQ(once.at(0).Far, 2);
    EXPECT_EQ(once.at(1).Far, 2);
  }
}

// Every way that shows both eyes draws them at once, the others do not.
TEST_F(EyesAtOnce, FollowTheStereoType)
{
  EyesScene scene("equirectangular", "omnidirectional");
  scene.AddRoom();
  const std::vector<Seen> twice = scene.DrawTwice();
  for (const int type : { VTK_STEREO_INTERLACED, VTK_STEREO_SPLITVIEWPORT_HORIZONTAL,
         VTK_STEREO_LEFT, VTK_STEREO_RIGHT, VTK_STEREO_ANAGLYPH })
  {
    SCOPED_TRACE(type);
    scene.Window->SetStereoType(type);
    const std::vector<Seen> seen = scene.Draw();
    const bool one = type == VTK_STEREO_LEFT || type == VTK_STEREO_RIGHT;
    ASSERT_EQ(seen.size(), one ? 1u : 2u);
    for (const Seen& eye : seen)
    {
      EXPECT_EQ(eye.Shared > 0, !one);
      EXPECT_EQ(CountChanged(eye, twice[eye.Eye < 0 ? 0 : 1]), 0);
    }
  }
  scene.Window->StereoRenderOff();
  EXPECT_EQ(scene.Draw().at(0).Shared, 0);
  scene.Window->StereoRenderOn();
  EXPECT_GT(scene.Draw().at(1).Shared, 0);
}

// What waits for the right eye is shown in its own frame alone.
TEST_F(EyesAtOnce, ShowNothingStale)
{
  EyesScene scene("equirectangular", "omnidirectional");
  scene.AddRoom();
  vtkActor* const ring = scene.AddRing();
  scene.Pass()->SetSortWhileMoving(true);
  std::vector<Seen> before = scene.Draw();
  const auto expect = [&](bool shared) {
    const std::vector<Seen> now = scene.Draw();
    ASSERT_EQ(now.size(), 2u);
    EXPECT_EQ(now[1].Shared > 0, shared);
    const std::vector<Seen> twice = scene.DrawTwice();
    for (std::size_t i = 0; i < 2; i++)
    {
      EXPECT_GT(CountChanged(now[i], before[i]), 0);
      EXPECT_EQ(CountChanged(now[i], twice[i]), 0);
    }
    before = now;
  };
  ring->RotateY(20);
  expect(true);
  scene.Camera->Yaw(30);
  expect(true);
  scene.Camera->SetInterpupillaryDistance(0.3);
  expect(true);
  ring->GetProperty()->SetColor(1, 0, 0);
  ring->GetMapper()->ScalarVisibilityOff();
  expect(true);
  scene.Renderer->SetBackground(0, 0.5, 0);
  ring->VisibilityOff();
  expect(true);
  scene.Window->SetSize(180, 120);
  scene.Draw();
  EXPECT_EQ(CountChanged(scene.Draw()[1], scene.DrawTwice()[1]), 0);
}

// Something moves when the left eye has been drawn.
TEST_F(EyesAtOnce, ShowWhatMovesBetweenTheTwo)
{
  EyesScene scene("equirectangular", "omnidirectional");
  scene.AddRoom();
  vtkActor* const ring = scene.AddRing();
  scene.Pass()->SetSortWhileMoving(true);
  const std::vector<Seen> before = scene.Draw();
  vtkNew<vtkCallbackCommand> move;
  move->SetClientData(ring);
  move->SetCallback([](vtkObject*, unsigned long, void* actor, void*) {
    static_cast<vtkActor*>(actor)->RotateY(25);
  });
  const unsigned long tag = scene.Renderer->AddObserver(vtkCommand::EndEvent, move);
  const std::vector<Seen> now = scene.Draw();
  scene.Renderer->RemoveObserver(tag);
  EXPECT_EQ(CountChanged(now.at(0), before.at(0)), 0);
  EXPECT_GT(now.at(0).Shared, 0);
  EXPECT_EQ(now.at(1).Shared, 0);
  ring->RotateY(-25); // where it was for the right eye
  EXPECT_EQ(CountChanged(now.at(1), scene.DrawTwice().at(1)), 0);
}

// Where it cannot be, both eyes are drawn as ever.
TEST_F(EyesAtOnce, KeepToTwoTraversalsWhereTheyMust)
{
  EyesScene scene("equirectangular", "omnidirectional");
  scene.AddRoom();
  EXPECT_GT(scene.Draw().at(0).Shared, 0);
  const auto expectNone = [&scene](const char* why) {
    for (const Seen& eye : scene.Draw())
    {
      EXPECT_EQ(eye.Shared, 0) << why;
    }
  };
  scene.Pass()->SetEyesAtOnce(vtkWideFoVPass::NEVER);
  expectNone("never");
  scene.Pass()->SetEyesAtOnce(vtkWideFoVPass::ALWAYS);
  scene.Renderer->SetPreserveColorBuffer(1);
  expectNone("preserved colours");
  scene.Renderer->SetPreserveColorBuffer(0);
  scene.Pass()->SetTechnique(vtkWideFoVPass::VERTEX);
  expectNone("vertex");
  scene.Pass()->SetTechnique(vtkWideFoVPass::EXACT);
  scene.Camera->SetStereoModel("mono");
  expectNone("mono");
  scene.Camera->SetStereoModel("warped");
  EXPECT_GT(scene.Draw().at(0).Shared, 0);
  scene.Camera->SetWarpedViewer(0.5, 0);
  expectNone("a viewer who stands beside the axis");
}

// Nor where OpenGL has no layers for it.
TEST(EyesInTurn, WhereThereAreNoLayers)
{
  if (HasLayers())
  {
    GTEST_SKIP() << "this OpenGL has GL_ARB_shader_viewport_layer_array";
  }
  EyesScene scene("equirectangular", "omnidirectional");
  scene.AddRoom();
  scene.AddRing();
  const std::vector<Seen> always = scene.Draw();
  ExpectSame(always, scene.DrawTwice(), 0);
  EXPECT_EQ(always.at(1).Draws, always.at(0).Draws);
}
