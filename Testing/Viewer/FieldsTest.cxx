// SPDX-License-Identifier: BSD-3-Clause
// Fields of view under zoom, through the projections and in windows of any shape: always
// what the projection can show, and the first ones again in the end.
#include "Viewing/Choices.h"
#include "Viewing/CommandText.h"
#include "Viewing/Fields.h"
#include "Viewing/Keys.h"
#include "Text/Messages.h"
#include "Viewing/Session.h"

#include <gtest/gtest.h>

#include <set>

using namespace widefov;

namespace
{
// Of angles in degrees after a few multiplications.
constexpr double Rounding = 1e-9;

Options Start(const std::string& projection, double horizontal, double vertical)
{
  Options o;
  o.Scene = "room";
  o.Projection = projection;
  o.View.HorizontalFov = horizontal;
  o.View.VerticalFov = vertical;
  o.Size = { { 800, 400 } };
  return o;
}

const std::array<std::array<int, 2>, 4> Sizes{ { { { 800, 400 } }, { { 1, 1 } }, { { 1, 16384 } },
  { { 16384, 1 } } } };
}

TEST(Fields, EveryZoomInEveryProjectionAndWindowCanBeDrawn)
{
  Options o = Start("equirectangular", 360, 180);
  Fields fields(o);
  std::set<std::string> seen;
  for (int i = 0; i < 40; i++)
  {
    StepProjection(o, fields, 1);
    seen.insert(o.Projection);
    for (const double factor : { 1., 0.5, 1e-9, 3., 1e9, 1e9, 0.7 })
    {
      fields.Zoom(o, factor);
      for (const std::array<int, 2>& size : Sizes)
      {
        o.Size = size;
        fields.Apply(o);
        EXPECT_EQ(WhyNot(o), "") << o.Projection << " " << size[0] << "x" << size[1];
      }
    }
  }
  EXPECT_EQ(seen.size(), wfv::Projections().size()); // the sampled one needs a file
}

TEST(Fields, GoingThroughTheProjectionsChangesNothing)
{
  Options o = Start("equirectangular", 300, 100);
  const Fields fields(o);
  const std::size_t count = wfv::Projections().size();
  for (const int step : { 1, -1 })
  {
    for (std::size_t i = 0; i < count; i++)
    {
      StepProjection(o, fields, step);
    }
    EXPECT_EQ(o.Projection, "equirectangular");
    EXPECT_NEAR(o.View.HorizontalFov, 300, Rounding);
    EXPECT_NEAR(o.View.VerticalFov, 100, Rounding);
  }
}

TEST(Fields, ZoomingBackIsExact)
{
  for (const char* projection : { "equirectangular", "hammer", "stereographic", "perspective" })
  {
    Options o = Start(projection, 90, 90);
    Fields fields(o);
    fields.Apply(o);
    const double before = o.View.HorizontalFov;
    EXPECT_TRUE(fields.Zoom(o, 0.5)) << projection;
    fields.Apply(o);
    EXPECT_LT(o.View.HorizontalFov, before);
    EXPECT_TRUE(fields.Zoom(o, 2));
    fields.Apply(o);
    EXPECT_NEAR(o.View.HorizontalFov, before, Rounding) << projection;
  }
}

TEST(Fields, WhatAlwaysShowsAllCannotBeZoomed)
{
  Options o = Start("equi-angular-cubemap", 360, 180);
  Fields fields(o);
  EXPECT_FALSE(fields.Zoom(o, 0.5));
  fields.Apply(o);
  EXPECT_EQ(o.View.HorizontalFov, 360);
}

TEST(Choices, EveryTechniqueInTurnWhereItCanDrawTheView)
{
  Options o = Start("equirectangular", 360, 180);
  std::set<std::string> seen;
  for (int i = 0; i < 5; i++)
  {
    EXPECT_TRUE(StepTechnique(o, 1));
    seen.insert(o.TechniqueName);
  }
  EXPECT_EQ(seen.size(), 5u);
  EXPECT_EQ(o.TechniqueName, "auto");
  EXPECT_TRUE(StepTechnique(o, -1));
  EXPECT_EQ(o.TechniqueName, "cubemap");
  EXPECT_FALSE(SetDebugView(o, true)) << "VTK's own pass has none";
  o.View.VerticalFov = 90;
  EXPECT_TRUE(GiveUpTechnique(o)) << "it always shows 180 degrees";
  EXPECT_EQ(o.TechniqueName, "auto");
  EXPECT_TRUE(SetDebugView(o, true));
}

TEST(Choices, TheDebugViewIsGivenUpWhereThereIsNone)
{
  Options o = Start("equirectangular", 360, 180);
  const Fields fields(o);
  ASSERT_TRUE(SetDebugView(o, true));
  for (int i = 0; i < 40 && o.Projection != "perspective"; i++)
  {
    StepProjection(o, fields, 1);
  }
  EXPECT_EQ(o.Projection, "perspective");
  EXPECT_FALSE(o.DebugView);
}

TEST(CommandText, QuotesForAShell)
{
  Options o = Start("hammer", 360, 180);
  o.Scene.clear();
  o.Files = { "it's a file.vtk" };
  EXPECT_NE(CommandText(o, o).find("widefov-render 'it'\\''s a file.vtk'"), std::string::npos);
}

TEST(Session, KeepsEveryValueOnALineOfItsOwn)
{
  const std::string text =
    SessionText({ { "FILE", "/data/it's \"it\" .vtk ", "" }, { "--no-smooth", "", "" } });
  EXPECT_NE(text.find("\nfile = \"/data/it's \"it\" .vtk \"\nno-smooth\n"), std::string::npos);
  EXPECT_THROW(SessionText({ { "FILE", "a\nb.vtk", "" } }), Failure);
}

TEST(Keys, EveryLetterOfTheHelpIsAKey)
{
  EXPECT_FALSE(ActionOf(0, false));
  for (const char key : { 'P', 'T' })
  {
    EXPECT_TRUE(ActionOf(key, false));
    EXPECT_TRUE(ActionOf(key, true));
  }
  for (const char key : { 'V', 'C', 'I', 'M', 'N', 'B', 'K', 'Q' })
  {
    EXPECT_TRUE(ActionOf(key, false)) << key;
  }
  for (const char key : { 'W', 'A', 'S', 'D', 'R', 'F' })
  {
    EXPECT_TRUE(MotionOf(key)) << key;
  }
}
