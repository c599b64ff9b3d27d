// SPDX-License-Identifier: BSD-3-Clause
// What the stereo models say of themselves, and where the eyes are.
#include "Stereo/Stereo.h"
#include "Views.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace wfv;
using namespace wfv::test;

namespace
{
// A projection that the model is for, as one eye sees it.
View SeenBy(const StereoOptions& stereo)
{
  const bool flat = stereo.Model->Traits.Flat;
  ViewOptions o;
  o.HorizontalFov = flat ? 100 : 360;
  o.VerticalFov = flat ? 70 : 180;
  o.Stereo = stereo;
  const Projection& p = *FindProjection(flat ? "perspective" : "hammer");
  EXPECT_EQ(CheckOptions(p, o), "") << stereo.Model->Name;
  return View(p, o);
}

// What the functions of a model do, as its traits say it.
StereoTraits TraitsSeen(const StereoModel& model)
{
  StereoOptions s;
  s.Model = &model;
  s.Eye = Eye::Left;
  const View left = SeenBy(s);
  s.Eye = Eye::Right;
  const View right = SeenBy(s);
  StereoTraits seen;
  seen.TwoEyes = false;
  seen.Flat = model.Traits.Flat;
  const vec3 center = right.Ray(vec2(0)).Origin;
  for (const vec3& d : RandomDirections(100))
  {
    const vec2 place = 0.5 * vec2(d);
    const ViewRay ray = right.RayAt(vec3(place, -0.5));
    seen.TwoEyes = seen.TwoEyes || left.Forward(3.0 * d).Ndc != right.Forward(3.0 * d).Ndc;
    seen.OneCenter = seen.OneCenter && ray.Origin == center;
    seen.StraightRays =
      seen.StraightRays && right.RayAt(vec3(place, 0.5)).Direction == ray.Direction;
  }
  return seen;
}
}

TEST(StereoTraits, TraitsSayWhatTheFunctionsDo)
{
  for (const StereoModel& model : StereoModels())
  {
    const StereoTraits seen = TraitsSeen(model);
    EXPECT_EQ(seen.TwoEyes, model.Traits.TwoEyes) << model.Name;
    EXPECT_EQ(seen.OneCenter, model.Traits.OneCenter) << model.Name;
    EXPECT_EQ(seen.StraightRays, model.Traits.StraightRays) << model.Name;
    EXPECT_EQ(model.FadesIn != nullptr, !model.Traits.OneCenter) << model.Name;
  }
}

TEST(StereoTraits, TheMiddleIsBetweenTheEyes)
{
  WfvView v{};
  v.halfEyes = 0.5;
  for (const Eye eye : { Eye::Left, Eye::Middle, Eye::Right })
  {
    v.eye = static_cast<int>(eye);
    EXPECT_EQ(wfvToRight(v), 0.5 * SideOf(eye));
    EXPECT_EQ(wfvFromMiddle(v), std::abs(wfvToRight(v)));
    v.eye = OtherEye(v.eye);
    EXPECT_EQ(wfvToRight(v), -0.5 * SideOf(eye));
  }
}

// A viewer who moves takes both eyes along.
TEST(StereoTraits, WithoutADistanceBothEyesSeeWhatTheMiddleSees)
{
  const vec3 point(0.3, 0.2, -2);
  const vec2 place(0.1, 0.2);
  for (const StereoModel& model : StereoModels())
  {
    StereoOptions s;
    s.Model = &model;
    s.Viewer = { { 0.2, 0.1 } };
    s.Separation = 0;
    WfvView v = SeenBy(s).GetParameters();
    v.halfEyes = 0;
    const WfvRayHit between = model.See(point, v);
    const vec2 shifted = model.Shift(place, 0.5, v);
    for (const int eye : { WFV_EYE_LEFT, WFV_EYE_RIGHT })
    {
      v.eye = eye;
      EXPECT_EQ(model.See(point, v).direction, between.direction) << model.Name;
      EXPECT_EQ(model.Shift(place, 0.5, v), shifted) << model.Name;
    }
  }
}
