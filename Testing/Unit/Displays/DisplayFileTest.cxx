// SPDX-License-Identifier: BSD-3-Clause
// Display files, and the tables that follow from them.
#include "DisplayFiles.h"
#include "Displays/DisplayFile.h"

#include <gtest/gtest.h>

using namespace wfv;
using namespace wfv::displays;
using namespace wfv::test;

namespace
{
// Radians: floats of tables.
constexpr double FloatRounding = 1e-6;

const std::string Dome = R"({
  // a dome of two projectors
  "eye": [0, 0.2, 0],
  "surface": { "type": "sphere", "radius": 5, "angle": 200 },
  "projectors": [
    { "name": "south", "size": [32, 20], "machine": "node1", "monitor": 0, "gamma": 2.4,
      "black-level": 0.01,
      "lens": { "position": [0, 0, 2], "direction": [0, 1.5, -1], "throw-ratio": 0.8 } },
    { "name": "north", "size": [32, 20], "machine": "node1", "monitor": 1,
      "lens": { "position": [0, 0, -2], "direction": [0, 1.5, 1], "throw-ratio": 0.8,
        "shift": [0, 0.1] } }
  ]
})";

std::string Replaced(std::string text, const std::string& from, const std::string& to)
{
  return text.replace(text.find(from), from.size(), to);
}

const std::string Mesh = "2\n2 2\n-1 -1 0 0 1\n1 -1 1 0 1\n-1 1 0 1 1\n1 1 1 1 1\n";

const std::string OneMesh = R"({ "picture": { "projection": "azimuthal-equidistant", "hfov": 200,
  "tilt": 30 }, "projectors": [ { "name": "one", "size": [16, 16], "calibration": "m.data" } ] })";
}

TEST(DisplayFile, SaysAll)
{
  const TemporaryFile file("dome.json", Dome);
  const DisplayFile display = ReadDisplay(file.Path);
  ASSERT_EQ(display.Projectors.size(), 2u);
  const DisplayProjector& south = display.Projectors[0];
  EXPECT_EQ(display.Eye, vec3(0, 0.2, 0));
  EXPECT_EQ(south.Name, "south");
  EXPECT_EQ(south.Machine, "node1");
  EXPECT_EQ(display.Projectors[1].Monitor, 1);
  EXPECT_EQ(south.Gamma, 2.4);
  EXPECT_EQ(south.BlackLevel, 0.01);
  EXPECT_EQ(display.Projectors[1].Gamma, 2.2);
  std::vector<std::string> notes;
  const std::vector<Table> tables = MakeTables(display, notes);
  ASSERT_EQ(tables.size(), 2u);
  EXPECT_EQ(tables[0].Lift.size(), tables[0].Count());
  EXPECT_TRUE(notes.empty());
  float least = 1;
  for (const float light : tables[0].Brightness)
  {
    least = std::min(least, light);
  }
  EXPECT_LT(least, 0.5); // blended
}

// A mesh refers to the picture that the file names, by the projection's own formula.
TEST(DisplayFile, PictureOfMesh)
{
  const TemporaryFile file("one.json", OneMesh);
  file.Add("m.data", Mesh);
  const DisplayFile display = ReadDisplay(file.Path);
  std::vector<std::string> notes;
  const Table table = MakeTables(display, notes).at(0);
  ViewOptions options;
  options.HorizontalFov = options.VerticalFov = 200;
  options.Tilt = 30;
  options.Aspect = 1;
  const View view(*FindProjection("azimuthal-equidistant"), options);
  for (std::size_t i = 0; i < table.Count(); i++)
  {
    const vec2 ndc((double(i % 16) + 0.5) / 8 - 1, (double(i / 16) + 0.5) / 8 - 1);
    const ViewRay ray = view.Ray(ndc);
    ASSERT_EQ(ray.Inside, !std::isnan(table.Values[i].x));
    if (ray.Inside)
    {
      EXPECT_LT(glm::length(table.Values[i] - ray.Direction), FloatRounding);
    }
  }
}

// Masks of files: applied by their gamma; of the wrong size, or beside a projector without one:
// told.
TEST(DisplayFile, Masks)
{
  const std::string masked =
    Replaced(OneMesh, "\"calibration\"", "\"mask\": \"m.png\", \"calibration\"");
  const TemporaryFile file("one.json", masked);
  file.Add("m.data", Mesh);
  file.Add("m.png", PngText(16, 16, std::vector<double>(256, 0.6)));
  std::vector<std::string> notes;
  const Table table = MakeTables(ReadDisplay(file.Path), notes).at(0);
  EXPECT_NEAR(table.Brightness[8 * 16 + 8], std::pow(0.6, 2.2), 1e-3);
  file.Add("m.png", PngText(8, 8, std::vector<double>(64, 0.6)));
  const std::string size = ErrorOf([&] { MakeTables(ReadDisplay(file.Path), notes); });
  EXPECT_NE(size.find("8x8 pixels, its projector 16x16"), std::string::npos) << size;

  file.Add("m.png", PngText(16, 16, std::vector<double>(256, 0.6)));
  file.Add("two.json",
    Replaced(
      masked, "} ] }", R"(}, { "name": "two", "size": [16, 16], "calibration": "m.data" } ] })"));
  const std::string one =
    ErrorOf([&] { MakeTables(ReadDisplay(file.Folder + "/two.json"), notes); });
  EXPECT_NE(one.find("two has none"), std::string::npos) << one;
}

struct BadDisplay
{
  std::string From;
  std::string To;
  const char* Says;
};

class BadDisplayTest : public testing::TestWithParam<BadDisplay>
{
};

TEST_P(BadDisplayTest, SaysWhere)
{
  const TemporaryFile file("dome.json", Replaced(Dome, GetParam().From, GetParam().To));
  std::vector<std::string> notes;
  const std::string error = ErrorOf([&] { MakeTables(ReadDisplay(file.Path), notes); });
  EXPECT_NE(error.find("dome.json"), std::string::npos) << error;
  EXPECT_NE(error.find(GetParam().Says), std::string::npos) << error;
  EXPECT_EQ(error.find('\n'), std::string::npos) << error;
}

INSTANTIATE_TEST_SUITE_P(All, BadDisplayTest,
  testing::ValuesIn(std::vector<BadDisplay>{ { "\"gamma\": 2.4,", "\"gamma\": 2.4", "line 7" },
    { "\"gamma\"", "\"gama\"", "projectors[0] has the unknown word 'gama'" },
    { "2.4", "\"2.4\"", "projectors[0].gamma needs a number from 0.1 to 10.0" },
    { "2.4", "1e400", "too large" }, { "\"north\"", "\"south\"", "two projectors south" },
    { "\"monitor\": 1", "\"monitor\": 0", "both on monitor 0" },
    { "\"radius\": 5", "\"radius\": -5", "surface.radius" },
    { "\"sphere\"", "\"torus\"", "surface.type needs sphere" },
    { "[0, 1.5, -1]", "[0, 1, 0]", "lens.up" }, { "[0, 1.5, -1]", "[0, 1]", "3 numbers" },
    { "[32, 20]", "[32.5, 20]", "projectors[0].size" },
    { "\"throw-ratio\": 0.8 }", "\"shift\": [0, 0] }", "no 'throw-ratio'" },
    { "\"surface\": { \"type\": \"sphere\", \"radius\": 5, \"angle\": 200 },", "", "surface" },
    { "\"lens\": { \"position\": [0, 0, 2]",
      "\"calibration\": \"x.data\", \"lens\": { \"position\": [0, 0, 2]", "calibration" } }));

// Regions of archives are asked for by name, and a display without projectors shows nothing.
TEST(DisplayFile, Regions)
{
  const std::string region = "<region id=\"a\" xResolution=\"4\" yResolution=\"4\"/>";
  const TemporaryFile file("wall.json", Replaced(OneMesh, "m.data", "w.mpcdi"));
  file.Add("w.mpcdi",
    ZipText({ { "mpcdi.xml",
      "<MPCDI profile=\"2d\" version=\"2.0\"><display><buffer>" + region +
        Replaced(region, "\"a\"", "\"b\"") + "</buffer></display></MPCDI>" } }));
  std::vector<std::string> notes;
  const std::string error = ErrorOf([&] { MakeTables(ReadDisplay(file.Path), notes); });
  EXPECT_NE(error.find("regions a, b"), std::string::npos) << error;
  file.Add("b.json", Replaced(OneMesh, "\"m.data\"", "\"w.mpcdi\", \"region\": \"b\""));
  EXPECT_EQ(ErrorOf([&] { MakeTables(ReadDisplay(file.Folder + "/b.json"), notes); }), "");
  file.Add("none.json", R"({ "projectors": [] })");
  EXPECT_NE(ErrorOf([&] { ReadDisplay(file.Folder + "/none.json"); }).find("one projector"),
    std::string::npos);
}
