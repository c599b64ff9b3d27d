// SPDX-License-Identifier: BSD-3-Clause
// Archives of all profiles of MPCDI, written by hand.
#include "DisplayFiles.h"
#include "Displays/Table.h"

#include <gtest/gtest.h>

using namespace wfv;
using namespace wfv::displays;
using namespace wfv::test;

namespace
{
// Radians or metres: floats of the maps.
constexpr double FloatRounding = 1e-6;

// Half a step of a mask of 8 bits.
constexpr double MaskStep = 0.5 / 255;

constexpr int Width = 6;
constexpr int Height = 4;

const std::string Frame = "<coordinateFrame><posx>1</posx><posy>2</posy><posz>3</posz>"
                          "<yawx>0</yawx><yawy>0</yawy><yawz>-1</yawz>"
                          "<pitchx>1</pitchx><pitchy>0</pitchy><pitchz>0</pitchz>"
                          "<rollx>0</rollx><rolly>1</rolly><rollz>0</rollz></coordinateFrame>";

std::string FrustumText(double yaw, double pitch, double roll)
{
  return "<frustum><yaw>" + std::to_string(yaw) + "</yaw><pitch>" + std::to_string(pitch) +
    "</pitch><roll>" + std::to_string(roll) +
    "</roll><rightAngle>45</rightAngle><leftAngle>-45</leftAngle>"
    "<upAngle>30</upAngle><downAngle>-30</downAngle></frustum>";
}

std::string Description(
  const std::string& profile, const std::string& inRegion, const std::string& files)
{
  return "<?xml version=\"1.0\"?><MPCDI profile=\"" + profile +
    "\" geometry=\"1\" version=\"2.0\"><display><buffer id=\"b\" xResolution=\"6\" "
    "yResolution=\"4\"><region id=\"left\" xResolution=\"6\" yResolution=\"4\" x=\"0\" y=\"0\" "
    "xSize=\"1\" ySize=\"1\">" +
    inRegion + "</region></buffer></display><files><fileset region=\"left\">" + files +
    "</fileset></files></MPCDI>";
}

std::string WarpText(const std::string& unit, const std::string& origin)
{
  return "<geometryWarpFile><path>left.pfm</path><interpolation>linear</interpolation>"
         "<geometricUnit>" +
    unit + "</geometricUnit><originOf3DData>" + origin + "</originOf3DData></geometryWarpFile>";
}

// A value a pixel, the bottom row first.
template <typename Form>
std::string Map(const Form& form)
{
  std::vector<vec3> values;
  for (int i = 0; i < Width * Height; i++)
  {
    values.push_back(form(vec2((i % Width + 0.5) / Width, (double(i / Width) + 0.5) / Height)));
  }
  return PfmText(Width, Height, values);
}

std::vector<Calibration> Read(std::map<std::string, std::string> parts)
{
  const TemporaryFile file("display.mpcdi", ZipText(parts));
  return ReadCalibrations(file.Path);
}

vec3 Straight(vec2 uv)
{
  return vec3(uv, 0);
}
}

// u and v of the whole picture, the caller's; alpha by its gamma, beta of its own size.
TEST(Mpcdi, Media)
{
  std::vector<double> alpha(Width * Height, 1);
  alpha[0] = 0.5; // upper left
  const std::string files = WarpText("2D", "") +
    "<alphaMap><path>a.png</path><componentDepth>1</componentDepth><bitDepth>8</bitDepth>"
    "<gammaEmbedded>2</gammaEmbedded></alphaMap><betaMap><path>b.png</path></betaMap>";
  const std::vector<Calibration> all = Read({ { "mpcdi.xml", Description("2d", "", files) },
    { "left.pfm", Map(Straight) }, { "a.png", PngText(Width, Height, alpha) },
    { "b.png", PngText(2, 2, { 0.2, 0.2, 0.2, 0.2 }, 16) } });
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].Name, "left");
  EXPECT_EQ(all[0].Size, (std::array<int, 2>{ Width, Height }));
  const Table table =
    MakeTable(all[0], Width, Height, [](vec2 uv) { return vec3(uv.x, uv.y, -1); });
  EXPECT_NEAR(table.Values[Width].y, 1.5 / Height, FloatRounding);
  EXPECT_NEAR(table.Values[Width].x, 0.5 / Width, FloatRounding);
  const double lift = 0.2 * 0.2;
  const std::size_t upperLeft = Width * (Height - 1);
  EXPECT_NEAR(table.Lift[0], lift, MaskStep);
  EXPECT_NEAR(table.Brightness[0], 1 - lift, MaskStep);
  EXPECT_NEAR(table.Brightness[upperLeft], 0.25 * (1 - lift), MaskStep);
}

// The region's own frustum, turned to the right, upwards and clockwise: each seen by itself.
TEST(Mpcdi, Simulation)
{
  const auto look = [](double yaw, double pitch, double roll, vec2 uv) {
    const auto all =
      Read({ { "mpcdi.xml", Description("3d", FrustumText(yaw, pitch, roll), WarpText("2D", "")) },
        { "left.pfm", Map(Straight) } });
    const Table table = MakeTable(all.at(0), Width, Height);
    const int x = static_cast<int>(uv.x * Width);
    const int y = static_cast<int>(uv.y * Height);
    return table.Values[static_cast<std::size_t>(y) * Width + x];
  };
  const double x = 1. / Width; // tangents of the pixel right of and above the middle
  const double y = std::tan(glm::radians(30.)) / Height;
  const vec2 pixel(0.51, 0.51);
  const auto near = [](const vec3& a, const vec3& b) {
    return glm::length(a - glm::normalize(b)) < FloatRounding;
  };
  EXPECT_TRUE(near(look(0, 0, 0, pixel), vec3(x, y, -1)));
  EXPECT_TRUE(near(look(90, 0, 0, pixel), vec3(1, y, x)));
  EXPECT_TRUE(near(look(0, 90, 0, pixel), vec3(x, 1, y)));
  EXPECT_TRUE(near(look(0, 0, 90, pixel), vec3(y, -x, -1))); // clockwise: right goes down
}

// Points of the room in centimetres, and a note where the origin is not the eye.
TEST(Mpcdi, Advanced)
{
  const auto point = [](vec2 uv) { return vec3(200 * uv.x - 100, 200 * uv.y - 100, -150); };
  const auto read = [&](const std::string& origin) {
    return Read({ { "mpcdi.xml", Description("a3d", "", WarpText("cm", origin)) },
      { "left.pfm", Map(point) } });
  };
  EXPECT_TRUE(read("idealEyePoint").at(0).Notes.empty());
  EXPECT_EQ(read("floorCenter").at(0).Notes.size(), 1u);
  const Table table = MakeTable(read("idealEyePoint")[0], Width, Height);
  EXPECT_EQ(table.What, Shows::Point);
  const vec3 corner(200. * 0.5 / Width - 100, 200. * 0.5 / Height - 100, -150);
  EXPECT_LT(glm::length(table.Values[0] - 0.01 * corner), FloatRounding);
  // from another eye the same point is elsewhere
  const vec3 eye(0.3, -0.2, 0.5);
  const std::vector<float> directions = DirectionsFrom(table, eye);
  const vec3 seen(directions[0], directions[1], directions[2]);
  EXPECT_LT(glm::length(seen - glm::normalize(0.01 * corner - eye)), FloatRounding);
}

// The surveyor's axes of Christie's files: z up, y ahead.
TEST(Mpcdi, ShaderLamp)
{
  const auto point = [](vec2 uv) { return vec3(uv.x, 5, uv.y); };
  const std::vector<Calibration> all =
    Read({ { "mpcdi.xml",
             Description("sl", FrustumText(0, 0, 0) + Frame, WarpText("m", "floorCenter")) },
      { "left.pfm", Map(point) } });
  ASSERT_TRUE(all.at(0).Lens);
  EXPECT_LT(glm::length(all[0].Lens->Position - vec3(1, 3, -2)), FloatRounding);
  const Table table = MakeTable(all[0], Width, Height);
  EXPECT_LT(glm::length(table.Values[0] - vec3(0.5 / Width, 0.5 / Height, -5)), FloatRounding);
}

// A description alone, beside its maps, as some programs write it; attributes in lower case.
TEST(Mpcdi, UnpackedAndWithoutMap)
{
  std::string text = Description("3d", FrustumText(0, 0, 0), "");
  const TemporaryFile file("wall.mpcdi.xml", text);
  const Table table = MakeTable(ReadCalibrations(file.Path).at(0), Width, Height);
  const vec3 corner(1. / Width - 1, (1. / Height - 1) * std::tan(glm::radians(30.)), -1);
  EXPECT_LT(glm::length(table.Values[0] - glm::normalize(corner)), FloatRounding);
}
