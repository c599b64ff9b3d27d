// SPDX-License-Identifier: BSD-3-Clause
#include "Loader.h"

#include "Pictures/CameraSetup.h"
#include "Pictures/EyeDistance.h"
#include "Pictures/FirstView.h"
#include "Text/Messages.h"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <regex>
#include <thread>
#include <utility>

namespace widefov
{
namespace
{
// Bytes that even the slowest reader has read before anybody wonders.
constexpr std::uintmax_t FewBytes = 1 << 20;

std::uintmax_t SizeOf(const std::filesystem::path& file)
{
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  return error ? 0 : size; // what is not there is said at once
}

// Of the files that one names, as .vtm and .gltf do.
std::uintmax_t SizeOfNamed(const std::filesystem::path& file)
{
  std::uintmax_t bytes = 0;
  const std::string ending = file.extension().string();
  if ((ending == ".vtm" || ending == ".gltf") && SizeOf(file) <= FewBytes)
  {
    std::ifstream stream(file, std::ios::binary);
    const std::string text{ std::istreambuf_iterator<char>(stream), {} };
    static const std::regex naming("(?:file=|\"uri\"\\s*:\\s*)\"([^\"]{1,255})\"");
    for (std::sregex_iterator i(text.begin(), text.end(), naming), end; i != end; ++i)
    {
      bytes += SizeOf(file.parent_path() / (*i)[1].str());
    }
  }
  return bytes;
}
}

bool AreLarge(const std::vector<std::string>& files)
{
  std::uintmax_t bytes = 0;
  for (const std::string& file : files)
  {
    bytes += SizeOf(file) + SizeOfNamed(file);
  }
  return bytes > FewBytes;
}

bool TakesLong(const Options& o)
{
  std::vector<std::string> all = o.Files;
  for (const std::string& file : o.Files)
  {
    try
    {
      const std::optional<DataSeries> series = DataSeries::Find(file);
      for (const TimeStep& step : series ? series->GetSteps() : std::vector<TimeStep>())
      {
        all.insert(all.end(), step.Files.begin(), step.Files.end());
      }
    }
    catch (const Failure&)
    {
      return false; // who reads it says so
    }
  }
  return AreLarge(all);
}

std::string NameOf(const Options& o)
{
  std::string name = o.Scene;
  for (const std::string& file : o.Files)
  {
    name += (name.empty() ? "" : " ") + file;
  }
  return name;
}

Loaded LoadFitted(Options& o, bool fits)
{
  auto steps = std::make_shared<FilmScenes>(o);
  Loaded loaded;
  loaded.What = steps->GetScene(steps->GetFirstStep());
  if (steps->GetSeries())
  {
    loaded.Steps = steps;
  }
  if (fits)
  {
    ChooseView(o, loaded.What.Props.empty() ? steps->GetFirstFilled() : loaded.What);
  }
  MakePose(loaded.What, o); // complains
  if (fits)
  {
    FitEyes(o, loaded.What);
  }
  return loaded;
}

Loader::Loader(std::function<void()> work)
{
  std::packaged_task<void()> task(std::move(work));
  this->Done = task.get_future();
  std::thread(std::move(task)).detach();
}

bool Loader::Wait(std::chrono::milliseconds time)
{
  return this->Done.wait_for(time) == std::future_status::ready;
}
}
