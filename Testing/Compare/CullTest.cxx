// SPDX-License-Identifier: BSD-3-Clause
// What a view leaves out is not in its picture: the same to the bit with everything drawn.
#include "CullCrowd.h"
#include "Meshes.h"

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkStripper.h>
#include <vtkWideFoVPolyDataMapper.h>

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <string>

using namespace wfv;
using namespace wfv::test;

namespace
{
constexpr int CullWidth = 192;
constexpr int CullHeight = 96;
constexpr int CullMeshes = 40;
constexpr int CullShots = 3; // a projection and technique

vtkSmartPointer<vtkPolyData> InStrips(vtkPolyData* mesh)
{
  vtkNew<vtkStripper> stripper;
  stripper->SetInputData(mesh);
  stripper->Update();
  return stripper->GetOutput();
}

// Meshes of several sizes, some of them near, and one round the eye that is cut in runs.
class Crowd : public CullCrowd
{
public:
  explicit Crowd(int samples)
    : CullCrowd(17, CullWidth, CullHeight, samples)
  {
    this->AddMesh(MakeRoom(40), vec3(0), 8, vec3(0.7, 0.7, 0.9));
    for (int i = 0; i < CullMeshes; ++i)
    {
      const vec3 at = 5.0 * this->Place();
      const vec3 colour = 0.6 + 0.4 * this->Place();
      // triangles of many pixels, and of a part of one, some of those in strips
      const auto globe = MakeGlobe(i % 4 ? 3 : 24);
      const auto mesh = i % 8 ? globe : InStrips(globe);
      this->AddMesh(mesh, at, 0.1 + 0.3 * std::abs(this->Unit()), colour);
    }
  }

private:
  void AddMesh(vtkPolyData* mesh, const vec3& at, double scale, const vec3& colour)
  {
    vtkNew<vtkWideFoVPolyDataMapper> mapper;
    mapper->SetInputData(mesh);
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->SetPosition(at.x, at.y, at.z);
    actor->SetScale(scale);
    actor->GetProperty()->SetColor(colour.x, colour.y, colour.z);
    this->Add(actor);
  }
};

// Both techniques that look at clusters.
LeftOut Compare(
  Crowd& crowd, const Projection& p, int autoShots = CullShots, int exactShots = CullShots)
{
  LeftOut left = crowd.Compare(p, vtkWideFoVPass::AUTO, autoShots);
  left += crowd.Compare(p, vtkWideFoVPass::EXACT, exactShots);
  return left;
}
}

TEST(Culling, ChangesNoPicture)
{
  Crowd crowd(0);
  LeftOut all;
  for (const Projection& p : Projections())
  {
    all += Compare(crowd, p);
  }
  std::cout << "props left out " << all.Props << ", clusters " << all.Clusters << std::endl;
  EXPECT_GT(all.Props, 100);
  EXPECT_GT(all.Clusters, 1000);
}

namespace
{
void CompareEyes(const std::string& model, int autoShots, int exactShots)
{
  Crowd crowd(0);
  crowd.SetStereo(model);
  LeftOut all;
  for (const char* name : { "equirectangular", "hammer", "azimuthal-equidistant", "mercator" })
  {
    all += Compare(crowd, *FindProjection(name), autoShots, exactShots);
  }
  std::cout << "props left out " << all.Props << ", clusters " << all.Clusters << std::endl;
  EXPECT_GT(all.Props, 20);
  EXPECT_GT(all.Clusters, 50);
}
}

TEST(Culling, ChangesNoPictureOfTwoEyes)
{
  CompareEyes("omnidirectional", CullShots, CullShots);
}

// A picture of curves takes its time, and both techniques draw the same.
TEST(Culling, ChangesNoPictureOfWarpedEyes)
{
  CompareEyes("warped", 2, 1);
}

// What is asked for one eye is known for the other, and neither is asked again while nothing
// changes.
TEST(Culling, AsksOnceForBothEyes)
{
  Crowd crowd(0);
  for (const char* const model : { "omnidirectional", "warped" })
  {
    crowd.SetStereo(model);
    crowd.Pass->SetTechnique(vtkWideFoVPass::AUTO);
    for (int i = 0; i < CullShots; ++i)
    {
      crowd.Point(*FindProjection("equirectangular"));
      crowd.Draw(false); // all of them: what is drawn first prepares its mapper, which changes it
      crowd.Draw(true);
      EXPECT_EQ(crowd.Pass->GetNumberOfChosenProps(), 0) << "of the second eye, " << model;
      EXPECT_EQ(crowd.Pass->GetNumberOfClassifiedMeshes(), 0)
        << "for the second eye, " << crowd.Text;
      crowd.Draw(true);
      EXPECT_EQ(crowd.Pass->GetNumberOfChosenProps(), 0) << model;
      EXPECT_EQ(crowd.Pass->GetNumberOfClassifiedMeshes(), 0) << model;
    }
    // the check can tell
    crowd.SetStereoRender(false);
    crowd.Draw(true);
    EXPECT_GT(crowd.Pass->GetNumberOfChosenProps(), 0);
    EXPECT_GT(crowd.Pass->GetNumberOfClassifiedMeshes(), 0);
  }
}

TEST(Culling, ChangesNoPictureOfManySamples)
{
  Crowd crowd(4);
  for (const char* name : { "equirectangular", "azimuthal-equidistant", "equi-angular-cubemap" })
  {
    Compare(crowd, *FindProjection(name));
  }
}
