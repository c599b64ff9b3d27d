// SPDX-License-Identifier: BSD-3-Clause
#include "Readers.h"

#include "Damage.h"
#include "Datasets.h"
#include "EmptyFile.h"
#include "FileKinds.h"
#include "GltfFile.h"
#include "NamedFiles.h"
#include "System/CrashGuard.h"
#include "System/InputFiles.h"
#include "System/MessageCatcher.h"
#include "System/Progress.h"
#include "Text/Messages.h"

#include <vtkInformation.h>
#include <vtkStreamingDemandDrivenPipeline.h>

#include <algorithm>
#include <cctype>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace widefov
{
namespace
{
// The data of a reader, with the times of its steps (TimesOf).
vtkSmartPointer<vtkDataObject> OutputOf(vtkAlgorithm* reader)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkDataObject* const data = reader->GetOutputDataObject(0);
  vtkInformation* const information = reader->GetOutputInformation(0);
  if (data != nullptr && information != nullptr && information->Has(Pipeline::TIME_STEPS()))
  {
    data->GetInformation()->CopyEntry(information, Pipeline::TIME_STEPS());
  }
  return data;
}

// time: of the step; none: the first.
vtkSmartPointer<vtkDataObject> Read(const std::string& path, const std::optional<double>& time)
{
  const vtkSmartPointer<vtkAlgorithm> reader = KindOf(path).MakeReader(path);
  if (time)
  {
    reader->UpdateTimeStep(*time);
  }
  else
  {
    reader->Update();
  }
  // the reader of legacy files tells the time 0 of each
  return EndingOf(path) == ".vtk" ? vtkSmartPointer<vtkDataObject>(reader->GetOutputDataObject(0))
                                  : OutputOf(reader);
}

void CheckRegular(const std::string& path)
{
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status))
  {
    Fail(path + ": there is no such file; check the name");
  }
  if (!std::filesystem::is_regular_file(status))
  {
    Fail(path + " is not a regular file; name a data file");
  }
  errno = 0;
  if (!std::ifstream(path, std::ios::binary))
  {
    Fail(path + " cannot be opened: " + std::strerror(errno) + "; check its permissions");
  }
  if (std::filesystem::file_size(path, error) == 0)
  {
    Fail(path + " is empty; check where it comes from");
  }
}

[[noreturn]] void FailDamaged(const std::string& path, const std::string& why)
{
  Fail(path + " cannot be read: " + why + "; check that the file is complete");
}

vtkSmartPointer<vtkDataObject> ReadGuarded(
  const std::string& path, const std::optional<double>& time)
{
  const QuietStandardError quiet;
  const Progress progress("reading " + path);
  const CrashGuard guard(path +
    " cannot be read: the reader crashed on it; check that the "
    "file is complete");
  return Read(path, time);
}

// Reads the file. Throws a Failure with ExitFailed if the reader complains.
vtkSmartPointer<vtkDataObject> ReadStrictly(
  const std::string& path, const std::optional<double>& time)
{
  MessageCatcher::TakeFirstError();
  MessageCatcher::TakeWarnings();
  vtkSmartPointer<vtkDataObject> data;
  try
  {
    data = ReadGuarded(path, time);
  }
  catch (const std::exception& error)
  {
    FailDamaged(path, error.what());
  }
  const std::string error = MessageCatcher::TakeFirstError();
  const std::string warning = WarningOfDamage(MessageCatcher::TakeWarnings());
  if (!error.empty() || !warning.empty())
  {
    // the pipeline's own words name an address, not what is wrong
    const bool words = error.rfind("Algorithm vtk", 0) != 0;
    FailDamaged(path, error.empty() ? warning : words ? error : "its reader does not know it");
  }
  return data;
}
}

std::vector<double> TimesOf(vtkDataObject* data)
{
  vtkInformation* const information = data->GetInformation();
  const auto key = vtkStreamingDemandDrivenPipeline::TIME_STEPS();
  const double* const times = information->Has(key) ? information->Get(key) : nullptr;
  return times ? std::vector<double>(times, times + information->Length(key))
               : std::vector<double>();
}

vtkSmartPointer<vtkDataObject> ReadFile(const std::string& path, const std::optional<double>& time)
{
  CheckRegular(path);
  KindOf(path);
  NoteInput(path);
  const std::vector<std::string> named = NamedFiles(path);
  std::for_each(named.begin(), named.end(), NoteInput);
  const std::string early = DamagedFile(path, EndingOf(path));
  if (!early.empty())
  {
    FailDamaged(path, early);
  }
  if (vtkSmartPointer<vtkDataObject> empty = EmptyData(path, EndingOf(path)))
  {
    return empty;
  }
  const vtkSmartPointer<vtkDataObject> data = ReadStrictly(path, time);
  if (Leaves(data).empty() && EndingOf(path) != ".vtm")
  {
    FailDamaged(path, "it holds no geometry");
  }
  const std::string damage = DamagedCells(data);
  if (!damage.empty())
  {
    FailDamaged(path, damage);
  }
  return data;
}

void DropUnusable(SceneProp& prop)
{
  const CleanResult clean = DropUnusableCells(prop.Surface);
  if (clean.Data->GetNumberOfCells() == 0)
  {
    Fail(prop.Label +
      ": none of its cells has coordinates that are all finite and below 1e18; there is nothing to "
      "draw, so check the data");
  }
  if (clean.Dropped > 0)
  {
    Say(prop.Label + ": " + std::to_string(clean.Dropped) +
      " cells left out, whose coordinates are not finite or beyond 1e18; check the data");
  }
  prop.Surface = clean.Data;
}

std::vector<SceneProp> PropsOf(vtkDataObject* data)
{
  std::vector<SceneProp> props;
  for (const auto& part : PartsByArrays(data))
  {
    SceneProp prop;
    prop.Source = part;
    prop.Surface = SurfaceOf(part);
    props.push_back(prop);
  }
  return props;
}

namespace
{
std::vector<SceneProp> ReadProps(const std::string& path, const std::optional<double>& time)
{
  const vtkSmartPointer<vtkDataObject> data = ReadFile(path, time);
  const Progress progress("taking the surface of " + path);
  std::vector<SceneProp> parts = IsGltf(path) ? ReadGltf(path) : std::vector<SceneProp>();
  if (parts.empty())
  {
    parts = PropsOf(data);
  }
  for (SceneProp& part : parts)
  {
    part.Globe = EndingOf(path) == ".nc" || EndingOf(path) == ".cdf";
  }
  return parts;
}
}

Scene ReadScene(const std::vector<std::string>& paths, const std::optional<double>& time)
{
  Scene scene;
  scene.FromFiles = true;
  for (std::size_t i = 0; i < paths.size(); i++)
  {
    Tell("reading " + paths[i]);
    for (SceneProp& prop : ReadProps(paths[i], time))
    {
      prop.Label = paths[i];
      prop.Index = static_cast<int>(i);
      scene.Props.push_back(prop);
    }
  }
  return scene;
}
}
