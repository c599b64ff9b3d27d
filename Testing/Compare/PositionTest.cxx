// SPDX-License-Identifier: BSD-3-Clause
// The picture does not jitter where the eye is close to a surface of a large scene, far
// from the origin, or looks at an actor that was moved far away: float32 in the vertex
// stage must be relative to the distance from the eye.
#include "DrawingTest.h"
#include "Meshes.h"
#include "Poses.h"
#include "vtkWideFoVPass.h"

#include <vtkPolyData.h>

#include <iostream>

using namespace wfv;
using namespace wfv::test;

namespace
{
// Pixels.
constexpr double PositionTolerance = 0.02;

// Relative error of the distance along the pixel's ray. float32 leaves 4e-7; double, of an
// eye at 1e5 and 1e-5 from the wall, another 1e-6.
constexpr double PositionDepthTolerance = 2e-6;

struct Place
{
  const char* Name;
  Placement Where;
  vec3 Actor{ 0 };
};

// Points are float where they reach the mapper's buffer as they are: what that holds is what
// the ray caster sees. VTK shifts and scales points whose box is far away for its size; those
// of a large box round the origin it would scale too, had their mapper not been told.
const Place WallPlaces[] = { { "at the origin", { vec3(0), 1, false } },
  { "points at 1e5", { vec3(1e5, -1e5, 1e5), 1, false } },
  { "actor at 1e5", { vec3(0), 1, false }, vec3(1e5, -1e5, 1e5) },
  { "size 1000", { vec3(0), 1000, false } } };

// From the eye to the wall, of the scene's half size, outside the near sphere. The corners of
// the wall's triangles are up to 10,000 times farther.
const double Gaps[] = { 1e-1, 1e-2, 1e-3, 1e-4, 1e-5 };
constexpr double NearRadius = 5e-6;
constexpr double FarRadius = 4;

// The mesh's point nearest to p.
vec3 NearestPoint(vtkPolyData* mesh, const vec3& p)
{
  double q[3] = { p.x, p.y, p.z };
  mesh->GetPoint(mesh->FindPoint(q), q);
  return vec3(q[0], q[1], q[2]);
}
}

class Position : public DrawingTest
{
protected:
  // Looks at a vertex of the wall x = 1 across the gap, at the density of 8192 all round.
  static Shot At(const Place& place, const std::string& projection, double gap, double y, double z)
  {
    const double scale = place.Where.Scale;
    const vec3 vertex =
      NearestPoint(Picture->GetMesh(), place.Where.Centre + vec3(1, y, z) * scale);
    NamedPose pose;
    pose.Eye = place.Actor + vertex + vec3(-1, 0.3, 0.2) * (gap * scale);
    pose.Direction = glm::normalize(vec3(1, -0.2, -0.3));
    Shot shot = MakeShot(projection, 45, pose);
    shot.Width = 1024;
    shot.Height = projection == "azimuthal-equidistant" ? 1024 : 512;
    shot.Options.VerticalFov = 45.0 * shot.Height / shot.Width;
    shot.Options.Radii = { { NearRadius * scale, FarRadius * scale } };
    return shot;
  }

  static void Check(const Shot& shot, const Place& place, double gap)
  {
    const reference::DrawnPicture picture = Picture->Draw(shot);
    ASSERT_EQ(picture.Width, shot.Width) << "nothing was drawn: " << Describe(shot);
    const reference::RayCaster caster(Picture->GetMesh(), Picture->GetView(), Picture->GetPose());
    const reference::Metrics m = reference::Compare(picture, caster, PositionTolerance);
    std::cout << Row(shot, place.Name + (" " + std::to_string(gap)), m) << std::endl;
    EXPECT_EQ(m.UnexplainedPixels, 0) << Describe(shot) << "\n"
                                      << Details(shot, Picture->GetView(), m);
    EXPECT_LE(m.MaxDepthRel, PositionDepthTolerance) << Describe(shot);
  }
};

TEST_P(Position, NearTheEyeAndFarFromTheOrigin)
{
  Picture->SetTechnique(vtkWideFoVPass::EXACT);
  for (const Place& place : WallPlaces)
  {
    Picture->SetMesh(MakeRoom(20, place.Where));
    Picture->SetActorPosition(place.Actor);
    for (double gap : Gaps)
    {
      for (double y : { 0.3, -0.62 })
      {
        Check(At(place, this->GetParam(), gap, y, 0.2 - y), place, gap);
      }
    }
  }
  Picture->SetActorPosition(vec3(0));
}

INSTANTIATE_TEST_SUITE_P(All, Position,
  ::testing::Values("equirectangular", "azimuthal-equidistant"), DrawingTest::NameOf);
