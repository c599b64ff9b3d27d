// SPDX-License-Identifier: BSD-3-Clause
// Command lines, lists and files of films that are refused, and in what words.
#include "Film/FilmPath.h"
#include "Options/Options.h"
#include "Options/ParseOptions.h"
#include "Scenes/DataSeries.h"
#include "System/OutputFiles.h"
#include "Text/Messages.h"

#include <gtest/gtest.h>

#include <fstream>
#include <functional>
#include <sstream>

namespace
{
using namespace widefov;

// Exit code and message of what is refused; 0 where it is not.
std::pair<int, std::string> Refusal(const std::function<void()>& work)
{
  try
  {
    work();
    return { ExitDone, "" };
  }
  catch (const Failure& failure)
  {
    return { failure.ExitCode, failure.what() };
  }
}

void Parse(const std::string& line)
{
  std::istringstream text("widefov-render --scene room " + line);
  std::vector<std::string> words;
  for (std::string word; text >> word;)
  {
    words.push_back(word);
  }
  std::vector<char*> pointers;
  for (std::string& word : words)
  {
    pointers.push_back(&word[0]);
  }
  Options options;
  ParseOptions(static_cast<int>(pointers.size()), pointers.data(), options);
}

void ExpectUsage(const std::string& line, const std::string& says)
{
  const auto [code, message] = Refusal([&line] { Parse(line); });
  EXPECT_EQ(code, ExitUsage) << line;
  EXPECT_NE(message.find(says), std::string::npos) << line << ": " << message;
}

TEST(FilmOptions, WhatDoesNotGoTogether)
{
  ExpectUsage("--seconds 3 -o a.png", "--seconds");
  ExpectUsage("--resume -o a.png", "--resume");
  ExpectUsage("--codec x264 -o a.png", "--codec");
  ExpectUsage("--film spiral -o a.mp4", "spiral");
  ExpectUsage("--film path -o a.mp4", "--path");
  ExpectUsage("--film turn --path way.txt -o a.mp4", "--path");
  ExpectUsage("--film fly -o a.mp4", "--vectors");
  ExpectUsage("--film turn", "nothing to write");
  ExpectUsage("--film turn -o picture.png", "numbered frames");
  ExpectUsage("--film turn -o film.avi", "numbered frames");
  ExpectUsage("--film turn -o -", "numbered frames");
  ExpectUsage("--film turn -o frames/%05d.bmp", ".png");
  ExpectUsage("--film turn --codec x264 -o film.webm", ".webm");
  ExpectUsage("--film turn --quality 60 -o film.mp4", "--quality");
  ExpectUsage("--film turn --quality 10 -o film.mov", "--quality");
  ExpectUsage("--film turn --size 63x32 -o film.mp4", "even");
  ExpectUsage("--film turn --aov a.exr -o film.mp4", "--aov");
  ExpectUsage("--film turn --audio a.wav -o frames/%05d.png", "--audio");
  ExpectUsage("--film turn --dry-run -o film.mp4", "--dry-run");
  ExpectUsage("--film turn -o film.mp4 -o film.mp4", "twice");
}

TEST(FilmOptions, ValuesOutOfRange)
{
  const std::pair<const char*, const char*> wrong[] = { { "--seconds", "0" },
    { "--seconds", "nan" }, { "--fps", "0" }, { "--fps", "1/0" }, { "--fps", "fast" },
    { "--part", "3/2" }, { "--part", "2" }, { "--part", "0/2" }, { "--sweep", "inf" },
    { "--quality", "-1" } };
  for (const auto& [option, value] : wrong)
  {
    ExpectUsage(std::string("--film turn -o film.mp4 ") + option + " " + value, option);
  }
  EXPECT_EQ(
    Refusal([] { Parse("--film turn --fps 30000/1001 --part 2/2 -o film.mp4"); }).first, ExitDone);
}

// Writes the file and refuses it.
void ExpectRefused(const std::string& name, const std::string& text, const std::string& says,
  const std::function<void(const std::string& path)>& read)
{
  const TemporaryFolder folder;
  const std::string path = folder.GetPath() + "/" + name;
  std::ofstream(path) << text;
  const auto [code, message] = Refusal([&] { read(path); });
  EXPECT_EQ(code, ExitFailed) << name << ": " << text;
  EXPECT_NE(message.find(says), std::string::npos) << name << ": " << message;
  EXPECT_NE(message.find(path), std::string::npos) << name << ": " << message;
}

TEST(FilmOptions, FilesOfPosesThatAreNone)
{
  const auto read = [](const std::string& path) { ReadPoses(path, { { 0, 1, 0 } }); };
  ExpectRefused("way.txt", "", "no pose", read);
  ExpectRefused("way.txt", "1 2 3\n", "line 1", read);
  ExpectRefused("way.txt", "0 0 0 0 0 -1\n0 0 0 0 0 x\n", "line 2", read);
  ExpectRefused("way.txt", "0 0 0 0 0 -1\n0 0 0 0 0 nan\n", "line 2", read);
  ExpectRefused("way.txt", "0 0 0 0 0 0\n", "direction", read);
  ExpectRefused("way.txt", "0 0 0 0 1 0 0 1 0\n", "up", read);
}

TEST(FilmOptions, ListsOfStepsThatAreNone)
{
  const auto read = [](const std::string& path) { DataSeries::Find(path); };
  ExpectRefused("empty.pvd", "<VTKFile><Collection/></VTKFile>", "names no file", read);
  ExpectRefused("text.pvd", "time goes by\n", "no list", read);
  ExpectRefused("none.vtp.series", "{\"files\": []}", "names no file", read);
  ExpectRefused("text.vtp.series", "time goes by\n", "no list", read);
  EXPECT_EQ(Refusal([] { DataSeries::Find("/nowhere/gone.pvd"); }).first, ExitFailed);
  EXPECT_EQ(Refusal([] { DataSeries::Find("/nowhere/flow_%04d.vtp"); }).first, ExitFailed);
}
}
