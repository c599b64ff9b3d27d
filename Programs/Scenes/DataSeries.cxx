// SPDX-License-Identifier: BSD-3-Clause
#include "DataSeries.h"

#include "FileKinds.h"
#include "NumberPattern.h"
#include "System/InputFiles.h"
#include "Text/Messages.h"

#include <nlohmann/json.hpp>
#include <vtkSmartPointer.h>
#include <vtkXMLDataElement.h>
#include <vtkXMLUtilities.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

namespace widefov
{
namespace
{
using StepList = std::vector<TimeStep>;

[[noreturn]] void FailList(const std::string& path, const std::string& why)
{
  Fail(path + " is no list of time steps: " + why + "; check the file");
}

// Names in a list are relative to its folder.
std::string BesideList(const std::string& list, const std::string& name)
{
  return (std::filesystem::path(list).parent_path() / name).string();
}

bool HasEnding(const std::string& path, const std::string& ending)
{
  return std::filesystem::path(path).extension() == ending;
}

void CheckList(const std::string& path)
{
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error) || !std::ifstream(path))
  {
    Fail(path + " is not there, or cannot be opened; check the name");
  }
}

// Files of one time are parts of one step.
StepList ReadPvd(const std::string& path)
{
  CheckList(path);
  const auto root =
    vtkSmartPointer<vtkXMLDataElement>::Take(vtkXMLUtilities::ReadElementFromFile(path.c_str()));
  vtkXMLDataElement* const list =
    root != nullptr ? root->FindNestedElementWithName("Collection") : nullptr;
  if (list == nullptr)
  {
    FailList(path, "it has no element Collection");
  }
  StepList steps;
  for (int i = 0; i < list->GetNumberOfNestedElements(); i++)
  {
    vtkXMLDataElement* const element = list->GetNestedElement(i);
    double time = i;
    element->GetScalarAttribute("timestep", time);
    const char* const file = element->GetAttribute("file");
    if (file == nullptr || !std::isfinite(time))
    {
      FailList(path, "an element DataSet has no file, or no finite timestep");
    }
    const auto same = std::find_if(
      steps.begin(), steps.end(), [time](const TimeStep& step) { return step.Time == time; });
    if (same == steps.end())
    {
      steps.push_back({ time, { BesideList(path, file) } });
    }
    else
    {
      same->Files.push_back(BesideList(path, file));
    }
  }
  return steps;
}

StepList ReadJson(const std::string& path)
{
  CheckList(path);
  std::ifstream file(path);
  const auto list = nlohmann::json::parse(file, nullptr, false);
  if (!list.is_object() || !list.contains("files") || !list["files"].is_array())
  {
    FailList(path, "it is no JSON object with an array 'files'");
  }
  StepList steps;
  for (const auto& entry : list["files"])
  {
    if (!entry.is_object() || !entry.contains("name") || !entry["name"].is_string())
    {
      FailList(path, "one of its files has no name");
    }
    const auto time = entry.find("time");
    const bool timed = time != entry.end() && time->is_number();
    steps.push_back({ timed ? time->get<double>() : static_cast<double>(steps.size()),
      { BesideList(path, entry["name"].get<std::string>()) } });
  }
  return steps;
}

StepList ListNumbered(const std::string& path, const NumberPattern& pattern)
{
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  StepList steps;
  std::error_code error;
  for (const auto& entry :
    std::filesystem::directory_iterator(folder.empty() ? "." : folder, error))
  {
    const std::string name = (folder / entry.path().filename()).string();
    if (const std::optional<long long> number = pattern.NumberIn(name))
    {
      steps.push_back({ static_cast<double>(*number), { name } });
    }
  }
  if (steps.empty())
  {
    Fail(path + ": there is no such numbered file; check the name");
  }
  return steps;
}

// None where there is one step or none: then it is a file as any other.
StepList ReadStepsOfFile(const std::string& path)
{
  StepList steps;
  const std::vector<double> times = TimesOfFile(path);
  for (std::size_t i = 0; i < times.size() && times.size() > 1; i++)
  {
    steps.push_back({ times[i], { path }, static_cast<int>(i) });
  }
  return steps;
}
}

DataSeries::DataSeries(std::string name, std::vector<TimeStep> steps)
  : Name(std::move(name))
  , Steps(std::move(steps))
{
  std::stable_sort(this->Steps.begin(), this->Steps.end(),
    [](const TimeStep& a, const TimeStep& b) { return a.Time < b.Time; });
}

std::optional<DataSeries> DataSeries::Find(const std::string& path)
{
  StepList steps;
  if (const std::optional<NumberPattern> pattern = NumberPattern::Parse(path))
  {
    steps = ListNumbered(path, *pattern);
  }
  else if (HasEnding(path, ".ex2") || HasEnding(path, ".case"))
  {
    steps = ReadStepsOfFile(path);
    if (steps.empty())
    {
      return std::nullopt;
    }
  }
  else if (HasEnding(path, ".pvd") || HasEnding(path, ".series"))
  {
    steps = HasEnding(path, ".pvd") ? ReadPvd(path) : ReadJson(path);
    if (steps.empty())
    {
      FailList(path, "it names no file");
    }
  }
  else
  {
    return std::nullopt;
  }
  NoteInput(path);
  for (const TimeStep& step : steps)
  {
    std::for_each(step.Files.begin(), step.Files.end(), NoteInput);
  }
  return DataSeries(path, steps);
}

DataSeries DataSeries::OfFiles(const std::vector<std::string>& paths)
{
  StepList steps;
  for (const std::string& path : paths)
  {
    steps.push_back({ static_cast<double>(steps.size()), { path } });
  }
  return { paths.front(), steps };
}

std::size_t DataSeries::StepAt(double share) const
{
  const double first = this->Steps.front().Time;
  const double span = this->Steps.back().Time - first;
  const double count = static_cast<double>(this->Steps.size());
  if (!(span > 0))
  {
    return std::min(this->Steps.size() - 1, static_cast<std::size_t>(share * count));
  }
  // what rounding takes must not make a step of equal ones come late
  const double now = first + (share + 1e-9) * span * count / (count - 1);
  return this->StepFor(now);
}

std::size_t DataSeries::StepFor(double time) const
{
  const auto after = std::upper_bound(this->Steps.begin(), this->Steps.end(), time,
    [](double t, const TimeStep& step) { return t < step.Time; });
  return after == this->Steps.begin() ? 0
                                      : static_cast<std::size_t>(after - this->Steps.begin()) - 1;
}

double DataSeries::ShareOf(std::size_t step) const
{
  const double count = static_cast<double>(this->Steps.size());
  const double span = this->Steps.back().Time - this->Steps.front().Time;
  if (!(span > 0) || step + 1 >= this->Steps.size())
  {
    return 1 / count;
  }
  return (this->Steps[step + 1].Time - this->Steps[step].Time) / span * (count - 1) / count;
}
}
