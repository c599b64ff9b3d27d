// SPDX-License-Identifier: BSD-3-Clause
// Files that are cut, damaged or of another kind: one line each, which names the file.
#include "DisplayFiles.h"
#include "Displays/Table.h"

#include <gtest/gtest.h>

#include <sys/stat.h>

using namespace wfv;
using namespace wfv::displays;
using namespace wfv::test;

namespace
{
const std::string Good = "2\n2 2\n-1 -1 0 0 1\n1 -1 1 0 1\n-1 1 0 1 1\n1 1 1 1 1\n";

// Reads a file of this name and returns the error, which names the file in one line.
std::string Said(const std::string& name, const std::string& bytes)
{
  const TemporaryFile file(name, bytes);
  const std::string error = ErrorOf([&] { ReadCalibrations(file.Path); });
  EXPECT_NE(error.find(name), std::string::npos) << error;
  EXPECT_EQ(error.find('\n'), std::string::npos) << error;
  return error;
}

struct BadFile
{
  const char* Name;
  std::string Bytes;
  const char* Says;
};

void PrintTo(const BadFile& bad, std::ostream* out)
{
  *out << bad.Name << " that " << bad.Says;
}

std::string Replaced(std::string text, const std::string& from, const std::string& to)
{
  return text.replace(text.find(from), from.size(), to);
}

std::string Nans(int width, int height)
{
  return PfmText(
    width, height, std::vector<vec3>(static_cast<std::size_t>(width) * height, vec3(std::nan(""))));
}

// u goes to the right and back again.
std::string Folded()
{
  std::vector<vec3> values;
  for (int i = 0; i < 64; i++)
  {
    values.emplace_back(1 - std::abs((i % 8) / 4. - 0.9), double(i / 8) / 8, 0);
  }
  return PfmText(8, 8, values);
}

const std::string Scalable = "OPENMESH Version 1.1\nNATIVEXRES 8\nNATIVEYRES 4\n"
                             "0 0 255 1 1\n8 0 255 1 0\n8 4 255 0 0\n[ 0 1 2 ]\n";

const std::string SkySkan = "Dome Azimuth=0\nDome Elevation=0\nHorizontal FOV=60\n2 2\n"
                            "0 0 0 0\n1 0 1 0\n0 1 0 1\n1 1 1 1\n";

const std::vector<BadFile> BadFiles{
  { "m.data", "", "needs the type" },
  { "m.data", "7\n2 2\n", "is no type" },
  { "m.data", "2\n2\n", "columns and rows" },
  { "m.data", "2\n1000000000 1000000000\n", "is no size" },
  { "m.data", "2\n-2 2\n", "is no size" },
  { "m.data", Good.substr(0, Good.size() - 10), "ends after 3 of 4 nodes" },
  { "m.data", Replaced(Good, "1 -1 1 0 1", "1 nan 1 0 1"), "line 4" },
  { "m.data", Replaced(Good, "1 -1 1 0 1", "1 inf 1 0 1"), "line 4" },
  { "m.data", Replaced(Good, "1 -1 1 0 1", "1 -1 1 0 x"), "five numbers" },
  { "m.data", Replaced(Good, "-1 1 0 1 1", "5 1 0 1 1"), "folds" },
  { "m.data",
    Replaced(Good, "1 -1 1 0 1\n-1 1 0 1 1\n1 1 1 1 1", "-1 -1 0 0 1\n-1 -1 0 0 1\n-1 -1 0 0 1"),
    "no triangle" },
  { "m.obj", "v 0 0 0\n", "no face" },
  { "m.obj", "v 0 0\nf 1 1 1\n", "line 1" },
  { "m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n", "'4' is none" },
  { "m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 x\n", "'x' is none" },
  { "m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2\n", "three corners" },
  { "m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "texture coordinates" },
  { "m.pfm", "Pf\n2 2\n-1\n", "PF" },
  { "m.pfm", "PF\n2 two\n-1\n", "width" },
  { "m.pfm", "PF\n2 2\n0\n", "scale" },
  { "m.pfm", "PF\n99999999 99999999\n-1\n", "width" },
  { "m.pfm", PfmText(4, 4, std::vector<vec3>(15, vec3(0.5))), "15 of 16 pixels" },
  { "m.pfm", Nans(3, 3), "no pixel shows" },
  { "m.pfm", Folded(), "folds" },
  { "m.sgc", "SG", "SGC" },
  { "m.sgc", std::string("SGC\x01\0\0", 6), "is cut" },
  { "m.sgc", std::string("SGC\x01\x01\0\0\0", 8), "cube" },
  { "m.txt", "some text\n", "columns and rows" },
  { "m.txt", Replaced(SkySkan, "Horizontal FOV=60", "Horizontal FOV=200"), "angles" },
  { "m.txt", Replaced(SkySkan, "Dome Azimuth=0\n", ""), "dome azimuth" },
  { "m.txt", Replaced(SkySkan, "1 1 1 1\n", ""), "ends after 3 of 4" },
  { "m.txt", Replaced(SkySkan, "=60", "=wide"), "number behind" },
  { "m.xml", "<GeometryFile><Geo", "byte" },
  { "m.xml", "<GeometryFile><GeometryDefinition/></GeometryFile>", "X-FlatParameters" },
  { "m.xml", "<html/>", "MPCDI" },
  { "m.ol", "some text\n", "OPENMESH" },
  { "m.ol", Scalable + "FACES 7\n", "is cut" },
  { "m.ol", Replaced(Scalable, "NATIVEXRES 8\n", ""), "NATIVEXRES" },
  { "m.ol", Scalable + "MAPPING PIXELS\n", "only 'normalized'" },
  { "m.ol", Replaced(Scalable, "[ 0 1 2 ]", "[ 0 1 9 ]"), "node 9" },
  { "m.csv", "x;y;u;v;column;row\n", "no mesh" },
  { "m.csv", "0;0;0;0;0;0\n1;0;1;0;1;0\n0;1;0;1;0;1\n", "no mesh" },
  { "m.csv", "0;0;0;0;0;0\n1;0;1;0;1;0\n0;1;0;1;0;1\n1;1;1;1;0;1\n", "missing" },
  { "m.csv", "0;0;0;0;0;0\n1;nan;1;0;1;0\n", "line 2" },
  { "m.mpcdi", "PK\x03\x04 and no more", "no zip archive" },
  { "m.mpcdi", "", "no zip archive" },
  { "m.mpcdi", ZipText({ { "left.pfm", "" } }), "no mpcdi.xml" },
  { "m.mpcdi", ZipText({ { "mpcdi.xml", "<MPCDI" } }), "no XML" },
  { "m.mpcdi", ZipText({ { "../mpcdi.xml", "<MPCDI/>" } }), "points outside" },
  { "m.mpcdi", ZipText({ { "/etc/mpcdi.xml", "<MPCDI/>" } }), "points outside" },
  { "m.mpcdi", ZipText({ { "mpcdi.xml", "<MPCDI profile=\"4d\" version=\"2.0\"/>" } }), "4d" },
  { "m.mpcdi", ZipText({ { "mpcdi.xml", "<MPCDI profile=\"2d\" version=\"3\"/>" } }), "version" },
  { "m.mpcdi", ZipText({ { "mpcdi.xml", "<MPCDI profile=\"2d\" version=\"2.0\"/>" } }),
    "no region" },
  { "m.exe", "", "ending" },
};
}

class BadFileTest : public testing::TestWithParam<BadFile>
{
};

TEST_P(BadFileTest, SaysWhatIsWrong)
{
  const std::string error = Said(GetParam().Name, GetParam().Bytes);
  EXPECT_NE(error.find(GetParam().Says), std::string::npos) << error;
}

INSTANTIATE_TEST_SUITE_P(All, BadFileTest, testing::ValuesIn(BadFiles));

// Every prefix of a good file is told to be cut, or is whole by its own rules; none hangs or
// crashes.
TEST(BadFiles, CutAnywhere)
{
  const std::string zip = ZipText({ { "mpcdi.xml",
    "<MPCDI profile=\"2d\" version=\"2.0\"><display><buffer><region id=\"a\" xResolution=\"2\" "
    "yResolution=\"2\"/></buffer></display></MPCDI>" } });
  const std::string pfm = PfmText(2, 2,
    std::vector<vec3>{
      vec3(0.1, 0.1, 0), vec3(0.9, 0.1, 0), vec3(0.1, 0.9, 0), vec3(0.9, 0.9, 0) });
  for (const auto& [name, bytes] : std::map<std::string, std::string>{ { "m.data", Good },
         { "m.pfm", pfm }, { "m.mpcdi", zip }, { "m.ol", Scalable }, { "m.txt", SkySkan } })
  {
    const TemporaryFile whole(name, bytes);
    EXPECT_EQ(ErrorOf([&] { ReadCalibrations(whole.Path); }), "");
    for (std::size_t size = 0; size + 2 < bytes.size(); size += 1 + size / 40)
    {
      const TemporaryFile cut(name, bytes.substr(0, size));
      const std::string error = ErrorOf([&] { ReadCalibrations(cut.Path); });
      EXPECT_EQ(error.find('\n'), std::string::npos) << error;
      if (name == "m.data" && size + 4 < bytes.size())
      {
        EXPECT_NE(error, "") << size;
      }
    }
  }
}

// Names that are no files at all: a pipe would be waited for.
TEST(BadFiles, NoFile)
{
  const TemporaryFile file("other", "");
  const std::string pipe = file.Folder + "/pipe.data";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  for (const std::string& path : { pipe, file.Folder + "/missing.mpcdi",
         file.Folder + "/missing.obj", std::string("/dev/zero.data") })
  {
    EXPECT_NE(ErrorOf([&] { ReadCalibrations(path); }).find("is not there"), std::string::npos);
  }
}

// Parts that the description names: outside of the archive, missing, damaged, of another kind.
TEST(BadFiles, PartsOfMpcdi)
{
  const auto description = [](const std::string& warp, const std::string& alpha) {
    return "<MPCDI profile=\"2d\" version=\"2.0\"><display><buffer><region id=\"a\" "
           "xResolution=\"2\" yResolution=\"2\"/></buffer></display><files><fileset region=\"a\">"
           "<geometryWarpFile><path>" +
      warp + "</path></geometryWarpFile><alphaMap><path>" + alpha +
      "</path></alphaMap></fileset></files></MPCDI>";
  };
  const auto said = [&](const std::string& warp, const std::string& alpha) {
    return Said("m.mpcdi",
      ZipText({ { "mpcdi.xml", description(warp, alpha) }, { "bad.pfm", "PF\n2 2\n-1\n" },
        { "bad.png", PngText(2, 2, { 1, 1, 1, 1 }).substr(0, 40) } }));
  };
  EXPECT_NE(said("../../secret.pfm", "").find("points outside"), std::string::npos);
  EXPECT_NE(said("C:\\secret.pfm", "").find("points outside"), std::string::npos);
  EXPECT_NE(said("none.pfm", "").find("no part 'none.pfm'"), std::string::npos);
  EXPECT_NE(said("bad.pfm", "").find("0 of 4 pixels"), std::string::npos);
  EXPECT_NE(said("", "bad.png").find("no PNG"), std::string::npos);
}

// A mesh that refers to a picture, and nobody says which; one that is beside the projector's.
TEST(BadFiles, NothingToShow)
{
  const TemporaryFile file("m.data", Good);
  const Calibration mesh = ReadCalibrations(file.Path).at(0);
  const std::string error = ErrorOf([&] { MakeTable(mesh, 4, 4); });
  EXPECT_NE(error.find("name its projection"), std::string::npos);
  const Content none = [](vec2) { return vec3(std::nan("")); };
  EXPECT_NE(ErrorOf([&] { MakeTable(mesh, 4, 4, none); }).find("shows nothing"), std::string::npos);
}
