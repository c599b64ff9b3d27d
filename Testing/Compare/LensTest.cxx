// SPDX-License-Identifier: BSD-3-Clause
// Measured lenses, and round maps whose axis is not in the middle of the picture, against the ray
// caster.
#include "DrawingTest.h"
#include "Meshes.h"
#include "Poses.h"
#include "Promise.h"
#include "vtkWideFoVPass.h"

#include <vtkPolyData.h>

#include <vector>

using namespace wfv;
using namespace wfv::test;

namespace
{
// Pixels: float32 in the shaders, double in the ray caster.
constexpr double LensExactness = 0.02;

struct NamedShot
{
  std::string Name;
  Shot What;
};

Shot LensShot(const std::string& projection, double fov, const MeasuredPicture& measured,
  const LensCoefficients& lens = {})
{
  const std::vector<NamedPose> poses = PlainPoses();
  Shot shot = MakeShot(projection, fov, poses.back());
  shot.Width = 300; // of pictures that are measured with more pixels
  shot.Height = 225;
  shot.Options.Tilt = 20;
  shot.Options.Measured = measured;
  shot.Options.Lens = lens;
  return shot;
}

// A calibrated fisheye and a calibrated rectilinear lens, pixels; a circle larger than the picture
// and beside it, and one in a corner; a map that is flat at its rim.
std::vector<NamedShot> LensShots()
{
  const MeasuredPicture fisheye{ vec2(400, 300), vec2(212.3, 139.8), vec2(121.7, 118.2) };
  const MeasuredPicture rectilinear{ vec2(800, 600), vec2(455.1, 288), vec2(520, 523) };
  const MeasuredPicture larger{ vec2(400, 300), vec2(-40, 420), vec2(150, 150) };
  const MeasuredPicture corner{ vec2(400, 300), vec2(320.5, 60.25), vec2(30, 30) };
  return { { "fisheye",
             LensShot("azimuthal-equidistant", 200, fisheye,
               { { 1, 0, -0.021, 0, 0.0043, 0, -0.0011, 0, 0.0002 } }) },
    { "rectilinear",
      LensShot("brown-conrady", 100, rectilinear, { { 1, 0, -0.08, 0, 0.02, 0, -0.001, 0, 0 } }) },
    { "larger than the picture", LensShot("azimuthal-equidistant", 360, larger) },
    { "in a corner", LensShot("stereographic", 220, corner) },
    { "flat rim",
      LensShot("orthographic", 180, { larger.Size, vec2(150, 180), vec2(140, 150) }) } };
}
}

class CompareLens : public DrawingTest
{
protected:
  static std::vector<vtkSmartPointer<vtkPolyData>> Meshes()
  {
    return { MakeRoom(1), MakeGlobe(24) };
  }
};

TEST_F(CompareLens, ExactIsTheRayCasters)
{
  Picture->SetTechnique(vtkWideFoVPass::EXACT);
  Picture->SetTolerance(LensExactness);
  for (const auto& mesh : Meshes())
  {
    Picture->SetMesh(mesh);
    for (const NamedShot& shot : LensShots())
    {
      const reference::DrawnPicture picture = Picture->Draw(shot.What);
      ASSERT_EQ(picture.Width, shot.What.Width) << "nothing was drawn: " << shot.Name;
      const reference::RayCaster caster(mesh, Picture->GetView(), Picture->GetPose());
      const reference::Metrics m = reference::Compare(picture, caster, LensExactness);
      EXPECT_EQ(m.UnexplainedPixels, 0) << shot.Name << "\n"
                                        << Details(shot.What, Picture->GetView(), m);
    }
  }
}

TEST_F(CompareLens, AutoIsAsPromised)
{
  Picture->SetTechnique(vtkWideFoVPass::AUTO);
  Picture->SetTolerance(0.25);
  for (const auto& mesh : Meshes())
  {
    Picture->SetMesh(mesh);
    for (const NamedShot& shot : LensShots())
    {
      const reference::DrawnPicture picture = Picture->Draw(shot.What);
      const HoleCount count = CountHoles(picture, Picture->GetView());
      EXPECT_EQ(count.Holes, 0) << shot.Name << "\n" << count.First;
      EXPECT_EQ(count.Outside, 0) << shot.Name << "\n" << count.First;
      ExpectPromise(*Picture, shot.What, picture, 0.25, shot.Name);
    }
  }
}
