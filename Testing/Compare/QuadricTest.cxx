// SPDX-License-Identifier: BSD-3-Clause
// Balls, sticks, tubes and points as spheres against the ray caster: what is seen at each
// pixel, how far away, and with which normal.
#include "Bodies.h"
#include "DrawingTest.h"
#include "Poses.h"
#include "QuadricCaster.h"
#include "Stereo/Stereo.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>

#include <algorithm>
#include <cstdio>
#include <iostream>

using namespace wfv;
using namespace wfv::test;

namespace
{
// Pixels: float32 in the shaders, double in the ray caster.
constexpr double QuadricTolerance = 0.02;

// Relative error of the distance along the pixel's ray, and error of the unit normal.
constexpr double QuadricDepthTolerance = 1e-5;
constexpr double NormalTolerance = 1e-4;

// Radians: how far float32 turns the ray of a pixel. Where the surface runs away from the
// eye, that ray meets it farther off, and there it faces another way.
constexpr double RayRounding = 3e-7;

// Degrees: a field of view that is drawn as finely as the whole sphere would be in a
// picture of 8192 pixels.
constexpr double Dense = 45;

constexpr double TubePixels = 7;
constexpr double PointPixels = 9;

// Relative to a centre's distance from the eye: its view coordinates are float32.
constexpr double CenterRounding = 2e-7;

// Relative: radii in pixels come from differences of the map, in float32.
constexpr double RadiusRounding = 1e-4;

// The largest error in units of what is allowed there, and where.
struct Worst
{
  double Ratio = 0;
  std::string Place;

  void Add(double error, double allowed, const reference::Hit& hit, int i, int j)
  {
    // a NaN must not pass for agreement
    if (!(error / allowed <= this->Ratio))
    {
      char text[200];
      std::snprintf(text, sizeof text, "pixel (%d, %d) cell %lld distance %g error %g allowed %g",
        i, j, static_cast<long long>(hit.Cell), hit.Distance, error, allowed);
      this->Ratio = std::isnan(error) ? INFINITY : error / allowed;
      this->Place = text;
    }
  }
};

struct Errors
{
  Worst Depth;
  Worst Normal;
  long Pixels = 0;
};

// How far the surface that is drawn may lie from the true one along the ray, over what
// the angle between them does to it.
double Shift(const reference::Hit& hit, const reference::Body& body, bool inPixels)
{
  const double place = std::max(glm::length(body.P), glm::length(body.Q));
  const double radius = inPixels ? RadiusRounding * std::max(body.R, body.S) : 0;
  return hit.Distance * RayRounding + CenterRounding * place + radius;
}

double SmallestRadius(const reference::Body& b)
{
  return b.Kind == reference::Body::Shape::Hull ? std::min(b.R, b.S) : b.R;
}

Errors Measure(vtkImageData* data, const reference::QuadricCaster& caster,
  const reference::HitPicture& truth, bool inPixels)
{
  vtkDataArray* cell = data->GetPointData()->GetArray("cell");
  vtkDataArray* distance = data->GetPointData()->GetArray("distance");
  vtkDataArray* normal = data->GetPointData()->GetArray("normal");
  Errors errors;
  for (int n = 0; n < truth.Width * truth.Height; n++)
  {
    const int i = n % truth.Width;
    const int j = n / truth.Width;
    const reference::Hit& hit = truth.At(i, j);
    const vtkIdType at = vtkIdType(truth.Height - 1 - j) * truth.Width + i;
    if (hit.Cell < 0 || cell->GetComponent(at, 0) != double(hit.Cell + 1))
    {
      continue;
    }
    const vec2 ndc = reference::PixelToNdc(i + 0.5, j + 0.5, truth.Width, truth.Height);
    const double facing = std::abs(glm::dot(caster.GetView().Ray(ndc).Direction, hit.Normal));
    const reference::Body& body = caster.GetBodies()[hit.Cell];
    const double shift = Shift(hit, body, inPixels) / std::max(facing, 1e-12);
    const vec3 drawn(
      normal->GetComponent(at, 0), normal->GetComponent(at, 1), normal->GetComponent(at, 2));
    errors.Depth.Add(std::abs(distance->GetComponent(at, 0) - hit.Distance),
      QuadricDepthTolerance * hit.Distance + shift, hit, i, j);
    errors.Normal.Add(
      glm::length(drawn - hit.Normal), NormalTolerance + shift / SmallestRadius(body), hit, i, j);
    errors.Pixels++;
  }
  return errors;
}
}

class CompareQuadrics : public DrawingTest
{
protected:
  static inline long Compared = 0; // pixels of all shots of a scene

  // What bodies of a size in pixels are measured by: both eyes see the same ones.
  static View Mono(const Shot& shot, const View& view)
  {
    ViewOptions options = shot.Options;
    options.Stereo = StereoOptions();
    options.Aspect = double(shot.Width) / shot.Height;
    options.Radii = { { view.GetParameters().radii.x, view.GetParameters().radii.y } };
    return View(view.GetProjection(), options);
  }

  static void Check(
    const Shot& shot, const std::string& scene, const BodyList& bodies, double pixels)
  {
    const reference::DrawnPicture picture = Picture->Draw(shot);
    ASSERT_EQ(picture.Width, shot.Width) << "nothing was drawn: " << Describe(shot);
    const View& view = Picture->GetView();
    const reference::QuadricCaster caster(
      InView(bodies, Picture->GetPose(), Mono(shot, view), pixels, shot.Width, shot.Height), view);
    const reference::HitPicture truth = caster.Render(shot.Width, shot.Height);
    const reference::Metrics m = reference::Compare(picture, caster, truth, QuadricTolerance);
    const Errors errors = Measure(Picture->GetData(), caster, truth, pixels > 0);
    std::cout << Row(shot, scene, m) << " errors of " << errors.Depth.Ratio << " and "
              << errors.Normal.Ratio << " allowed, " << errors.Pixels << " pixels" << std::endl;
    EXPECT_EQ(m.UnexplainedPixels, 0) << scene << "\n  " << Describe(shot) << "\n"
                                      << Details(shot, view, m);
    Compared += errors.Pixels;
    EXPECT_LE(errors.Depth.Ratio, 1)
      << scene << "\n  " << Describe(shot) << "\n  " << errors.Depth.Place;
    EXPECT_LE(errors.Normal.Ratio, 1)
      << scene << "\n  " << Describe(shot) << "\n  " << errors.Normal.Place;
  }

  void CheckAll(vtkActor* actor, const std::string& scene, const BodyList& bodies, double pixels)
  {
    const Projection& p = *FindProjection(this->GetParam());
    Picture->SetActor(actor);
    Compared = 0;
    for (double fov : { Dense, 120.0, 360.0 })
    {
      if (fov < 360 && pixels > 0 && p.Axis == Family::Azimuthal)
      {
        continue; // many ends lie outside the map, where a pixel has no angle of its own
      }
      for (const NamedPose& pose : PlainPoses())
      {
        Shot shot = MakeShot(p.Name, fov, pose);
        shot.Width *= fov == Dense ? 2 : 1;
        shot.Height *= fov == Dense ? 2 : 1;
        Check(shot, scene + ", " + pose.Name, bodies, pixels);
      }
    }
    EXPECT_GT(Compared, 10000) << scene;
  }
};

// What each eye's own rays see.
class CompareStereoQuadrics : public CompareQuadrics
{
protected:
  void CheckBoth(vtkActor* actor, const std::string& scene, const BodyList& bodies, double pixels)
  {
    const Projection& p = *FindProjection(this->GetParam());
    Picture->SetActor(actor);
    Compared = 0;
    for (double ipd : { 0.02, 0.2 })
    {
      for (Eye eye : { Eye::Left, Eye::Right })
      {
        Shot shot = MakeShot(p.Name, 360, PlainPoses().back());
        shot.Options.Stereo.Model = FindStereoModel("omnidirectional");
        shot.Options.Stereo.Eye = eye;
        shot.Options.Stereo.InterpupillaryDistance = ipd;
        Check(shot, scene + (eye == Eye::Left ? ", left" : ", right"), bodies, pixels);
      }
    }
    EXPECT_GT(Compared, 10000) << scene;
  }
};

TEST_P(CompareStereoQuadrics, Balls)
{
  const BodyList balls = BallsRoundTheEye(false);
  this->CheckBoth(BallActor(balls), "balls", balls, 0);
}

TEST_P(CompareStereoQuadrics, BallsInsideABall)
{
  const BodyList balls = BallsRoundTheEye(true);
  this->CheckBoth(BallActor(balls), "balls inside a ball", balls, 0);
}

TEST_P(CompareStereoQuadrics, Sticks)
{
  const BodyList sticks = SticksRoundTheEye();
  this->CheckBoth(StickActor(sticks), "sticks", sticks, 0);
}

TEST_P(CompareStereoQuadrics, Tubes)
{
  const BodyList segments = SegmentsRoundTheEye();
  this->CheckBoth(TubeActor(segments, TubePixels), "tubes", segments, TubePixels);
}

TEST_P(CompareStereoQuadrics, Points)
{
  const BodyList points = PointsRoundTheEye();
  this->CheckBoth(PointActor(points, PointPixels), "points", points, PointPixels);
}

TEST_P(CompareQuadrics, Balls)
{
  const BodyList balls = BallsRoundTheEye(false);
  this->CheckAll(BallActor(balls), "balls", balls, 0);
}

TEST_P(CompareQuadrics, BallsInsideABall)
{
  const BodyList balls = BallsRoundTheEye(true);
  this->CheckAll(BallActor(balls), "balls inside a ball", balls, 0);
}

TEST_P(CompareQuadrics, Sticks)
{
  const BodyList sticks = SticksRoundTheEye();
  this->CheckAll(StickActor(sticks), "sticks", sticks, 0);
}

TEST_P(CompareQuadrics, Tubes)
{
  const BodyList segments = SegmentsRoundTheEye();
  this->CheckAll(TubeActor(segments, TubePixels), "tubes", segments, TubePixels);
}

TEST_P(CompareQuadrics, Points)
{
  const BodyList points = PointsRoundTheEye();
  this->CheckAll(PointActor(points, PointPixels), "points", points, PointPixels);
}

INSTANTIATE_TEST_SUITE_P(
  All, CompareStereoQuadrics, ::testing::ValuesIn(WideNames()), DrawingTest::NameOf);
INSTANTIATE_TEST_SUITE_P(
  All, CompareQuadrics, ::testing::ValuesIn(WideNames()), DrawingTest::NameOf);
