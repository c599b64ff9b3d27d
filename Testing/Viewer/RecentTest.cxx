// SPDX-License-Identifier: BSD-3-Clause
// The list of recent files, and that of poses.
#include "Text/Messages.h"
#include "System/OutputFiles.h"
#include "Viewing/PoseList.h"
#include "Viewing/Recent.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

namespace
{
std::string Make(const std::string& path, const std::string& text)
{
  std::ofstream(path, std::ios::binary) << text;
  return path;
}

std::string TextOf(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(file), {});
}
}

TEST(Recent, KeepsTheLastOnesInOrder)
{
  const widefov::TemporaryFolder folder;
  const std::string a = Make(folder.GetPath() + "/a.vtp", "a");
  const std::string b = Make(folder.GetPath() + "/b.vtp", "b");
  const std::string file = folder.GetPath() + "/state/widefov/recent";
  widefov::Recent recent(file);
  EXPECT_TRUE(recent.Get().empty());
  recent.Add({ a });
  recent.Add({ b });
  EXPECT_EQ(widefov::Recent(file).Get(), (std::vector<std::string>{ b, a }));
  recent.Add({ a });
  EXPECT_EQ(recent.Get(), (std::vector<std::string>{ a, b }));
  std::filesystem::remove(a);
  EXPECT_EQ(recent.Get(), std::vector<std::string>{ b });
}

TEST(Recent, NeverFails)
{
  const widefov::TemporaryFolder folder;
  const std::string a = Make(folder.GetPath() + "/a.vtp", "a");
  widefov::Recent nowhere("");
  nowhere.Add({ a });
  EXPECT_TRUE(nowhere.Get().empty());
  widefov::Recent closed(a + "/widefov/recent"); // in what is no folder
  closed.Add({ a });
  EXPECT_TRUE(closed.Get().empty());
}

TEST(PoseList, GrowsByWholeLines)
{
  const widefov::TemporaryFolder folder;
  const std::string file = Make(folder.GetPath() + "/tour.txt", "0 0 0 0 0 -1 0 1 0"); // no end
  EXPECT_EQ(widefov::AppendPose(file, { { 1, 2, 3 } }, { { 0, 0, -1 } }, { { 0, 1, 0 } }), 2u);
  EXPECT_EQ(TextOf(file), "0 0 0 0 0 -1 0 1 0\n1 2 3 0 0 -1 0 1 0\n");
  EXPECT_THROW(
    widefov::AppendPose(folder.GetPath() + "/nowhere/tour.txt", {}, {}, {}), widefov::Failure);
}
