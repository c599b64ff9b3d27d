// SPDX-License-Identifier: BSD-3-Clause
// What films compute: names, ways, times, the boxes of MP4 files.
#include "Scenes/DataSeries.h"
#include "Film/FilmPath.h"
#include "Film/Mp4Boxes.h"
#include "Scenes/NumberPattern.h"
#include "Text/Messages.h"
#include "System/OutputFiles.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

namespace
{
using namespace widefov;

TEST(Film, NumbersInNames)
{
  const auto pattern = NumberPattern::Parse("frames/dome_%05d.png");
  ASSERT_TRUE(pattern);
  EXPECT_EQ(pattern->Name(7), "frames/dome_00007.png");
  EXPECT_EQ(pattern->Name(1234567), "frames/dome_1234567.png");
  EXPECT_EQ(pattern->NumberIn("frames/dome_00042.png").value_or(-1), 42);
  for (const char* const other : { "frames/dome_42.png", "frames/dome_00042.jpg",
         "frames/dome_-0042.png", "frames/dome_.png", "frames/dome_0004x.png" })
  {
    EXPECT_FALSE(pattern->NumberIn(other)) << other;
  }
  for (const char* const none : { "film.png", "%d/film.png", "a%db%d.png", "a%s.png", "%99d.png" })
  {
    EXPECT_FALSE(NumberPattern::Parse(none)) << none;
  }
}

TEST(Film, SmoothWaysHaveOneSpeedBetweenTheirEnds)
{
  constexpr int Frames = 1001;
  const auto at = [](int frame) { return ShareOfWay(frame, Frames, false, true); };
  EXPECT_DOUBLE_EQ(at(0), 0);
  EXPECT_DOUBLE_EQ(at(Frames - 1), 1);
  const double speed = at(501) - at(500);
  for (int i = 1; i < Frames; i++)
  {
    const double step = at(i) - at(i - 1);
    EXPECT_GE(step, 0);
    EXPECT_LE(step, speed * (1 + 1e-9));
    if (i > 160 && i < 840)
    {
      EXPECT_NEAR(step, speed, 1e-12) << i;
    }
  }
  EXPECT_LT(at(1), 1e-7); // no jerk
  EXPECT_DOUBLE_EQ(ShareOfWay(3, 4, true, false), 0.75);
  EXPECT_DOUBLE_EQ(ShareOfWay(0, 1, false, true), 0);
}

TEST(Film, PosesAtOnePlaceGiveOneAngularSpeed)
{
  const auto at = [](double degrees) {
    const double a = degrees * std::acos(-1) / 180;
    return Pose{ { { 1, 2, 3 } }, { { std::sin(a), 0, -std::cos(a) } }, { { 0, 1, 0 } } };
  };
  const FilmPath path = PathThrough({ at(0), at(10), at(100), at(250) });
  for (int i = 0; i <= 250; i++)
  {
    const Pose pose = path.At(i / 250.);
    const Pose want = at(i);
    for (int k = 0; k < 3; k++)
    {
      EXPECT_NEAR(pose.Direction[k], want.Direction[k], 1e-6) << i;
      EXPECT_NEAR(pose.Eye[k], want.Eye[k], 1e-12);
      EXPECT_NEAR(pose.Up[k], want.Up[k], 1e-9);
    }
  }
}

TEST(Film, WaysGoThroughTheirPoses)
{
  const Pose a{ { { 0, 0, 0 } }, { { 0, 0, -1 } }, { { 0, 1, 0 } } };
  const Pose b{ { { 1, 0, 0 } }, { { 0, 0, -1 } }, { { 0, 1, 0 } } };
  const Pose c{ { { 1, 3, 0 } }, { { 0, 0, -1 } }, { { 0, 1, 0 } } };
  const FilmPath path = PathThrough({ a, b, c });
  for (const auto& [share, pose] : { std::pair(0., a), std::pair(0.25, b), std::pair(1., c) })
  {
    for (int k = 0; k < 3; k++)
    {
      EXPECT_NEAR(path.At(share).Eye[k], pose.Eye[k], 1e-9) << share;
    }
  }
  EXPECT_EQ(PathThrough({ a }).At(0.5).Eye, a.Eye);
}

TEST(Film, StepsAreSeenAsLongAsTheirTimesSay)
{
  const DataSeries even = DataSeries::OfFiles({ "a", "b", "c", "d" });
  const DataSeries uneven("list", { { 8, { "c" } }, { 0, { "a" } }, { 1, { "b" } } });
  for (int i = 0; i < 4; i++)
  {
    EXPECT_EQ(even.StepAt(i / 4.), static_cast<std::size_t>(i));
    EXPECT_EQ(even.StepAt((i + 0.99) / 4.), static_cast<std::size_t>(i));
  }
  EXPECT_EQ(uneven.StepAt(0.05), 0u);
  EXPECT_EQ(uneven.StepAt(0.1), 1u);
  EXPECT_EQ(uneven.StepAt(0.65), 1u);
  EXPECT_EQ(uneven.StepAt(0.67), 2u);
  EXPECT_EQ(DataSeries("one", { { 3, { "a" } } }).StepAt(0.9), 0u);
  EXPECT_EQ(uneven.StepFor(-1), 0u);
  EXPECT_EQ(uneven.StepFor(7.9), 1u);
  EXPECT_EQ(uneven.StepFor(8), 2u);
  EXPECT_NEAR(uneven.ShareOf(0), 1 / 12., 1e-12);
  EXPECT_NEAR(uneven.ShareOf(1), 7 / 12., 1e-12);
  EXPECT_NEAR(uneven.ShareOf(2), 4 / 12., 1e-12);
}

// ftyp, mdat, moov with one table of chunks.
std::string SmallFilm(std::uint64_t place)
{
  const Mp4Box table{ "stco", Mp4Number(0, 4) + Mp4Number(1, 4) + Mp4Number(place, 4), {} };
  const Mp4Box tables{ "stbl", "", { table } };
  const Mp4Box movie{ "moov", "",
    { { "trak", "", { { "mdia", "", { { "minf", "", { tables } } } } } } } };
  return BoxBytes({ "ftyp", "isom", {} }) + BoxBytes({ "mdat", "frame", {} }) + BoxBytes(movie);
}

std::string Rewritten(const std::string& film)
{
  const TemporaryFolder folder;
  const std::string path = folder.GetPath() + "/film.mp4";
  std::ofstream(path, std::ios::binary) << film;
  std::string bytes;
  RewriteMovie(
    path,
    [](Mp4Box& movie) {
      movie.Children.push_back({ "free", "room", {} });
    },
    [&bytes](const char* part, std::size_t count) { bytes.append(part, count); });
  return bytes;
}

TEST(Film, ChunksStayWhereTheTablesSay)
{
  const std::string before = SmallFilm(20);
  ASSERT_EQ(before.substr(20, 5), "frame");
  const std::string after = Rewritten(before);
  EXPECT_LT(after.find("moov"), after.find("mdat"));
  const std::size_t table = after.find("stco") + 12;
  ASSERT_LT(table, after.size());
  std::uint64_t place = 0;
  for (std::size_t i = 0; i < 4; i++)
  {
    place = place << 8 | static_cast<unsigned char>(after[table + i]);
  }
  EXPECT_EQ(after.substr(place, 5), "frame");
}

TEST(Film, PlacesBeyondFourGigabytesHaveRoom)
{
  const std::string before = SmallFilm(0xfffffff0);
  const std::string after = Rewritten(before);
  const std::size_t table = after.find("co64");
  ASSERT_NE(table, std::string::npos);
  EXPECT_EQ(after.find("stco"), std::string::npos);
  const std::size_t shift = after.find("mdat") - before.find("mdat");
  EXPECT_EQ(after.substr(table + 12, 8), Mp4Number(0xfffffff0 + std::uint64_t(shift), 8));
}

TEST(Film, DamagedBoxesAreRefused)
{
  const std::string film = SmallFilm(20);
  for (std::size_t size : { std::size_t(0), std::size_t(5), film.size() - 1, film.size() - 30 })
  {
    EXPECT_THROW(Rewritten(film.substr(0, size)), Failure) << size;
  }
}
}
