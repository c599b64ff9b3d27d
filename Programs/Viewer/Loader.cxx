// SPDX-License-Identifier: BSD-3-Clause
#include "Loader.h"

#include "Pictures/CameraSetup.h"
#include "Pictures/EyeDistance.h"
#include "Pictures/FirstView.h"
#include "Scenes/NamedFiles.h"
#include "Text/Messages.h"

#include <filesystem>
#include <optional>
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

std::uintmax_t SizeOfNamed(const std::string& file)
{
  std::uintmax_t bytes = 0;
  for (const std::string& name : NamedFiles(file))
  {
    bytes += SizeOf(name);
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
