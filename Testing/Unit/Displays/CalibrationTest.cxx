// SPDX-License-Identifier: BSD-3-Clause
// Files written by hand from the descriptions of their formats, against closed forms.
#include "DisplayFiles.h"
#include "Displays/DisplayFile.h"
#include "Displays/Table.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <ctime>

using namespace wfv;
using namespace wfv::displays;
using namespace wfv::test;

namespace
{
// Radians: what floats of the files and of the tables leave.
constexpr double FloatRounding = 1e-6;

// Radians: numbers of text, in double.
constexpr double TextRounding = 1e-9;

// Rounding of a brightness to float.
constexpr double LightRounding = 1e-6;

double AngleBetween(const vec3& a, const vec3& b)
{
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

// A fisheye of 180 degrees, equidistant, that looks ahead.
vec3 Fisheye(vec2 uv)
{
  const vec2 p = 2. * uv - 1.;
  const double r = glm::length(p);
  const double theta = r * 0.5 * WFV_PI;
  const vec2 out = r > 0 ? p / r : vec2(1, 0);
  return r > 1 ? vec3(std::nan(""))
               : vec3(std::sin(theta) * out.x, std::sin(theta) * out.y, -std::cos(theta));
}

// u, v of the centre of a pixel, from the lower left corner.
vec2 CentreOf(const Table& table, std::size_t i)
{
  return vec2(
    (double(i % table.Width) + 0.5) / table.Width, (double(i / table.Width) + 0.5) / table.Height);
}

// The largest angle to the closed form over all pixels, which must show something where it does.
template <typename Form>
double WorstAngle(const Table& table, const Form& form)
{
  double worst = 0;
  for (std::size_t i = 0; i < table.Count(); i++)
  {
    const vec3 expected = form(CentreOf(table, i));
    EXPECT_EQ(std::isnan(expected.x), std::isnan(table.Values[i].x)) << "pixel " << i;
    if (!std::isnan(expected.x) && !std::isnan(table.Values[i].x))
    {
      worst = std::max(worst, AngleBetween(expected, table.Values[i]));
    }
  }
  return worst;
}

Table ReadTable(const TemporaryFile& file, int width, int height)
{
  const std::vector<Calibration> all = ReadCalibrations(file.Path);
  EXPECT_EQ(all.size(), 1u);
  return MakeTable(all.at(0), width, height, Fisheye);
}
}

// A rectangular mesh whose u and v are an affine map of x and y, so that every triangle has it.
TEST(Calibration, Bourke)
{
  const auto map = [](vec2 uv) { return vec2(0.2 + 0.5 * uv.x + 0.1 * uv.y, 0.1 + 0.6 * uv.y); };
  std::string text = "2\n3 2\n";
  for (int i = 0; i < 6; i++)
  {
    const vec2 uv(0.5 * (i % 3), i / 3);
    const vec2 shown = map(uv);
    // x from -aspect to aspect, of 16 x 8 pixels
    text += Text({ 2 * (2 * uv.x - 1), 2 * uv.y - 1, shown.x, shown.y, 0.25 + 0.5 * uv.x });
  }
  const Table table = ReadTable(TemporaryFile("mesh.data", text), 16, 8);
  EXPECT_LT(WorstAngle(table, [&](vec2 uv) { return Fisheye(map(uv)); }), TextRounding);
  // values of nodes multiply those of the picture: linear light is to the power of the gamma
  EXPECT_NEAR(table.Brightness[0], std::pow(0.25 + 0.5 * 0.5 / 16, 2.2), LightRounding);
}

// A node of negative intensity takes its triangles away; a polar mesh has no seam.
TEST(Calibration, BourkeHoles)
{
  std::string text = "2\n2 2\n";
  text += Text({ -1, -1, 0, 0, 1 }) + Text({ 1, -1, 1, 0, -1 });
  text += Text({ -1, 1, 0, 1, 1 }) + Text({ 1, 1, 1, 1, 1 });
  const Table holed = ReadTable(TemporaryFile("mesh.data", text), 8, 8);
  EXPECT_TRUE(std::isnan(holed.Values[7].x));      // lower right
  EXPECT_FALSE(std::isnan(holed.Values[8 * 5].x)); // left
  EXPECT_EQ(holed.Brightness[7], 0);

  std::string polar = "1\n8 2\n";
  for (int i = 0; i < 16; i++)
  {
    const double angle = 2 * WFV_PI * (i % 8) / 8;
    const double r = i / 8 == 0 ? 0.2 : 0.9;
    const vec2 p = r * vec2(std::cos(angle), std::sin(angle));
    polar += Text({ p.x, p.y, 0.5 * p.x + 0.5, 0.5 * p.y + 0.5, 1 });
  }
  const Table round = ReadTable(TemporaryFile("mesh.data", polar), 64, 64);
  const std::size_t seam = 64 * 29 + 50; // right of the middle, just below: the last column
  EXPECT_LT(AngleBetween(round.Values[seam], Fisheye(CentreOf(round, seam))), TextRounding);
}

TEST(Calibration, Obj)
{
  // two triangles of four points, v and vt by their own numbers, and a quad of one's own
  const std::string text = "# a mesh\nv -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\n"
                           "vt 0.9 0.2\nvt 0.1 0.2\nvt 0.1 0.8\nvt 0.9 0.8\nvn 0 0 1\n"
                           "f 1/2/1 2/1/1 3/4/1 4/3/1\n";
  const Table table = ReadTable(TemporaryFile("mesh.obj", text), 12, 10);
  const auto form = [](vec2 uv) { return Fisheye(vec2(0.1 + 0.8 * uv.x, 0.2 + 0.6 * uv.y)); };
  EXPECT_LT(WorstAngle(table, form), TextRounding);
}

// Rows from the bottom, in either order of bytes, with pixels that show nothing.
TEST(Calibration, Pfm)
{
  const auto map = [](vec2 uv) { return vec2(0.1 + 0.8 * uv.x, 0.3 + 0.5 * uv.y); };
  for (const bool bigEndian : { false, true })
  {
    std::vector<vec3> values;
    for (int i = 0; i < 12 * 6; i++)
    {
      values.emplace_back(map(vec2((i % 12 + 0.5) / 12, (double(i / 12) + 0.5) / 6)), 0);
    }
    values[13].x = std::nan("");
    const Table table =
      ReadTable(TemporaryFile("map.pfm", PfmText(12, 6, values, bigEndian)), 12, 6);
    const auto form = [&](vec2 uv) {
      const bool hole = int(uv.x * 12) == 1 && int(uv.y * 6) == 1;
      return hole ? vec3(std::nan("")) : Fisheye(map(uv));
    };
    EXPECT_LT(WorstAngle(table, form), FloatRounding);
  }
}

// Quarter sizes: what lies between the file's pixels is bilinear, so that an affine map stays one.
TEST(Calibration, PfmOfAnotherSize)
{
  std::vector<vec3> values;
  for (int i = 0; i < 8 * 8; i++)
  {
    values.emplace_back((i % 8 + 0.5) / 8, (double(i / 8) + 0.5) / 8, 0);
  }
  const Table table = ReadTable(TemporaryFile("map.pfm", PfmText(8, 8, values)), 24, 24);
  const std::size_t middle = 24 * 7 + 9;
  EXPECT_LT(AngleBetween(table.Values[middle], Fisheye(CentreOf(table, middle))), FloatRounding);
}

TEST(Calibration, Sciss)
{
  // a view that is turned by 90 degrees to the left about the vertical, 60 x 40 degrees
  const double s = std::sqrt(0.5);
  std::string bytes("SGC\x01", 4);
  bytes += Bytes(std::uint32_t{ 0 });
  for (const double number : { 0., s, 0., s, 0., 0., 0., 20., -20., -30., 30. })
  {
    bytes += Bytes(static_cast<float>(number));
  }
  bytes += Bytes(std::uint32_t{ 2 }) + Bytes(std::uint32_t{ 2 });
  for (int i = 0; i < 4; i++)
  {
    // y of the picture from above, v of the texture from below
    for (const double number : { double(i % 2), double(i / 2), 0., double(i % 2), 1. - i / 2, 0. })
    {
      bytes += Bytes(static_cast<float>(number));
    }
  }
  bytes += Bytes(std::uint32_t{ 4 });
  for (const std::uint32_t index : { 0u, 1u, 2u, 3u })
  {
    bytes += Bytes(index);
  }
  const Table table = ReadTable(TemporaryFile("mesh.sgc", bytes), 9, 6);
  const auto form = [](vec2 uv) {
    const double x = (2 * uv.x - 1) * std::tan(glm::radians(30.));
    const double y = (2 * uv.y - 1) * std::tan(glm::radians(20.));
    return vec3(-1, y, -x); // ahead is -x now, and right -z
  };
  EXPECT_LT(WorstAngle(table, form), FloatRounding);
}

TEST(Calibration, SkySkan)
{
  std::string text = "Dome Azimuth=90\nDome Elevation=0\nHorizontal FOV=60\nVertical FOV=40\n"
                     "Horizontal Tweak=1\nVertical Tweak=-1\nU Tweak=1\nV Tweak=1\n\n3 2\n";
  for (int i = 0; i < 6; i++)
  {
    text += Text({ 0.5 * (i % 3), double(i / 3), 0.5 * (i % 3), double(i / 3) });
  }
  const Table table = ReadTable(TemporaryFile("mesh.txt", text), 8, 6);
  const auto form = [](vec2 uv) {
    const double x = (2 * uv.x - 1) * std::tan(glm::radians(30.));
    const double y = (2 * uv.y - 1) * std::tan(glm::radians(20.));
    return vec3(1, y, x); // turned to the right: ahead is x, right z
  };
  EXPECT_LT(WorstAngle(table, form), TextRounding);
}

TEST(Calibration, Simcad)
{
  // a square of 3 x 3, moved by a tenth to the right and a fifth downwards
  const std::string offsets = " 0.2 0.2 0.2 0.2 0.2 0.2 0.2 0.2 0.2";
  const std::string text = "<?xml version=\"1.0\"?><GeometryFile><GeometryDefinition>"
                           "<X-FlatParameters range=\"2\">" +
    offsets + "</X-FlatParameters><Y-FlatParameters range=\"1\">" + offsets +
    "</Y-FlatParameters></GeometryDefinition></GeometryFile>";
  const Table table = ReadTable(TemporaryFile("mesh.xml", text), 20, 20);
  const auto form = [](vec2 uv) {
    const vec2 shown = uv - vec2(0.1, -0.2);
    const bool inside = shown.x >= 0 && shown.y <= 1;
    return inside ? Fisheye(shown) : vec3(std::nan(""));
  };
  EXPECT_LT(WorstAngle(table, form), TextRounding);
}

TEST(Calibration, Scalable)
{
  const std::string text = "OPENMESH Version 1.1\nVERTICES 4\nFACES 2\nMAPPING NORMALIZED\n"
                           "SAMPLING LINEAR\nPROJECTION PERSPECTIVE\nNATIVEXRES 8\nNATIVEYRES 4\n"
                           "PERSPECTIVE_YAW 90\nPERSPECTIVE_LEFT -30\nPERSPECTIVE_RIGHT 30\n"
                           "PERSPECTIVE_TOP 20\nPERSPECTIVE_BOTTOM -20\nGAMMA 2\n"
                           "0 0 255 1 1\n8 0 255 1 0\n8 4 51 0 0\n0 4 51 0 1\n"
                           "[ 0 1 2 ]\n[ 0 2 3 ]\n";
  const std::vector<Calibration> all = ReadCalibrations(TemporaryFile("mesh.ol", text).Path);
  EXPECT_EQ(all.at(0).Size, (std::array<int, 2>{ 8, 4 }));
  const Table table = MakeTable(all[0], 8, 4);
  const auto form = [](vec2 uv) {
    const double x = (2 * uv.x - 1) * std::tan(glm::radians(30.));
    const double y = (2 * uv.y - 1) * std::tan(glm::radians(20.));
    return vec3(-1, y, -x);
  };
  EXPECT_LT(WorstAngle(table, form), TextRounding);
  EXPECT_NEAR(table.Brightness[0], 0.9 * 0.9, LightRounding); // an eighth of the way to 0.2
}

TEST(Calibration, Domeprojection)
{
  std::string text = "x;y;u;v;column;row\n";
  for (int row = 0; row < 3; row++)
  {
    for (int column = 0; column < 2; column++)
    {
      const double y = 0.5 * row;
      text += std::to_string(column) + ";" + std::to_string(y) + ";" +
        std::to_string(0.25 + 0.5 * column) + ";" + std::to_string(0.2 + 0.4 * y) + ";" +
        std::to_string(column) + ";" + std::to_string(row) + "\r\n";
    }
  }
  const Table table = ReadTable(TemporaryFile("mesh.csv", text), 10, 8);
  const auto form = [](vec2 uv) {
    return Fisheye(vec2(0.25 + 0.5 * uv.x, 1 - (0.2 + 0.4 * (1 - uv.y))));
  };
  EXPECT_LT(WorstAngle(table, form), TextRounding);
}

// Five numbers a node, of eight digits: the largest of the formats of text.
TEST(Calibration, ReadsLargeMeshesFast)
{
  // Seconds of processor time, the best of three: what a program may wait for a mesh of 500 x 500.
  constexpr double longest = 0.2;
  constexpr int side = 500;
  std::string text = "2\n500 500\n";
  for (int i = 0; i < side * side; i++)
  {
    const vec2 uv((i % side) / (side - 1.), double(i / side) / (side - 1));
    char line[80];
    std::snprintf(
      line, sizeof line, "%.8f %.8f %.8f %.8f 1\n", 2 * uv.x - 1, 2 * uv.y - 1, uv.x, uv.y);
    text += line;
  }
  const TemporaryFile file("mesh.data", text);
  double took = 10 * longest;
  for (int i = 0; i < 3; i++)
  {
    const std::clock_t start = std::clock();
    const std::vector<Calibration> all = ReadCalibrations(file.Path);
    took = std::min(took, double(std::clock() - start) / CLOCKS_PER_SEC);
    EXPECT_EQ(all.at(0).Mesh.Nodes.size(), std::size_t{ side * side });
  }
  EXPECT_LT(took, longest);
  RecordProperty("seconds", std::to_string(took));
}
