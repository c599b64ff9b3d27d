// SPDX-License-Identifier: BSD-3-Clause
#include "Readers.h"

#include "Damage.h"
#include "Datasets.h"
#include "EmptyFile.h"
#include "GltfFile.h"
#include "System/CrashGuard.h"
#include "System/MessageCatcher.h"
#include "System/Progress.h"
#include "Text/Messages.h"
#include "Text/OptionValues.h"

#include <vtkBYUReader.h>
#include <vtkExodusIIReader.h>
#include <vtkGLTFReader.h>
#include <vtkGenericDataObjectReader.h>
#include <vtkInformation.h>
#include <vtkNetCDFCFReader.h>
#include <vtkNew.h>
#include <vtkOBJReader.h>
#include <vtkPDBReader.h>
#include <vtkPLYReader.h>
#include <vtkSTLReader.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkXMLImageDataReader.h>
#include <vtkXMLMultiBlockDataReader.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLRectilinearGridReader.h>
#include <vtkXMLStructuredGridReader.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <algorithm>
#include <cctype>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace widefov
{
namespace
{
using ReadFunction = vtkSmartPointer<vtkDataObject> (*)(const std::string& path);

// What it read; the times of its steps go along (TimesOf).
vtkSmartPointer<vtkDataObject> OutputOf(vtkAlgorithm* reader)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkDataObject* const data = reader->GetOutputDataObject(0);
  vtkInformation* const information = reader->GetOutputInformation(0);
  if (data != nullptr && information->Has(Pipeline::TIME_STEPS()))
  {
    data->GetInformation()->CopyEntry(information, Pipeline::TIME_STEPS());
  }
  return data;
}

template <class Reader>
vtkSmartPointer<vtkDataObject> ReadPlain(const std::string& path)
{
  vtkNew<Reader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  return OutputOf(reader);
}

// Legacy files may hold several arrays of each kind; VTK reads one where nothing is said.
vtkSmartPointer<vtkDataObject> ReadLegacy(const std::string& path)
{
  vtkNew<vtkGenericDataObjectReader> reader;
  reader->SetFileName(path.c_str());
  reader->ReadAllScalarsOn();
  reader->ReadAllVectorsOn();
  reader->ReadAllNormalsOn();
  reader->ReadAllTensorsOn();
  reader->ReadAllColorScalarsOn();
  reader->ReadAllTCoordsOn();
  reader->ReadAllFieldsOn();
  reader->Update();
  return reader->GetOutputDataObject(0);
}

vtkSmartPointer<vtkDataObject> ReadByu(const std::string& path)
{
  vtkNew<vtkBYUReader> reader;
  reader->SetGeometryFileName(path.c_str());
  reader->Update();
  return reader->GetOutput();
}

// All arrays, first time step.
vtkSmartPointer<vtkDataObject> ReadExodus(const std::string& path)
{
  vtkNew<vtkExodusIIReader> reader;
  reader->SetFileName(path.c_str());
  reader->UpdateInformation();
  reader->SetAllArrayStatus(vtkExodusIIReader::NODAL, 1);
  reader->SetAllArrayStatus(vtkExodusIIReader::ELEM_BLOCK, 1);
  reader->Update();
  return OutputOf(reader);
}

// Longitude and latitude become a unit globe.
vtkSmartPointer<vtkDataObject> ReadNetCdf(const std::string& path)
{
  vtkNew<vtkNetCDFCFReader> reader;
  reader->SetFileName(path.c_str());
  reader->SphericalCoordinatesOn();
  reader->ReplaceFillValueWithNanOn();
  reader->Update();
  return OutputOf(reader);
}

struct Format
{
  const char* Ending;
  ReadFunction Read;
};

const std::vector<Format>& Formats()
{
  static const std::vector<Format> all{
    { ".vtk", ReadLegacy },
    { ".vtp", ReadPlain<vtkXMLPolyDataReader> },
    { ".vtu", ReadPlain<vtkXMLUnstructuredGridReader> },
    { ".vti", ReadPlain<vtkXMLImageDataReader> },
    { ".vts", ReadPlain<vtkXMLStructuredGridReader> },
    { ".vtr", ReadPlain<vtkXMLRectilinearGridReader> },
    { ".vtm", ReadPlain<vtkXMLMultiBlockDataReader> },
    { ".stl", ReadPlain<vtkSTLReader> },
    { ".ply", ReadPlain<vtkPLYReader> },
    { ".obj", ReadPlain<vtkOBJReader> },
    { ".g", ReadByu },
    { ".pdb", ReadPlain<vtkPDBReader> },
    { ".ex2", ReadExodus },
    { ".nc", ReadNetCdf },
    { ".cdf", ReadNetCdf },
    { ".glb", ReadPlain<vtkGLTFReader> },
    { ".gltf", ReadPlain<vtkGLTFReader> },
  };
  return all;
}

std::string EndingOf(const std::string& path)
{
  std::string ending = std::filesystem::path(path).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending;
}

ReadFunction ReaderFor(const std::string& path)
{
  const std::string ending = EndingOf(path);
  for (const Format& format : Formats())
  {
    if (ending == format.Ending)
    {
      return format.Read;
    }
  }
  Fail(path + ": no reader for '" + ending + "'; convert it to one of " +
    Join(ReadableEndings(), " "));
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

vtkSmartPointer<vtkDataObject> ReadGuarded(const std::string& path, ReadFunction read)
{
  const QuietStandardError quiet;
  const Progress progress("reading " + path);
  const CrashGuard guard(path +
    " cannot be read: the reader crashed on it; check that the "
    "file is complete");
  return read(path);
}

// Reads the file. Throws a Failure with ExitFailed if the reader complains.
vtkSmartPointer<vtkDataObject> ReadStrictly(const std::string& path, ReadFunction read)
{
  MessageCatcher::TakeFirstError();
  MessageCatcher::TakeWarnings();
  vtkSmartPointer<vtkDataObject> data;
  try
  {
    data = ReadGuarded(path, read);
  }
  catch (const std::exception& error)
  {
    FailDamaged(path, error.what());
  }
  const std::string error = MessageCatcher::TakeFirstError();
  const std::string warning = WarningOfDamage(MessageCatcher::TakeWarnings());
  if (!error.empty() || !warning.empty())
  {
    FailDamaged(path, error.empty() ? warning : error);
  }
  return data;
}
}

std::vector<std::string> ReadableEndings()
{
  std::vector<std::string> endings;
  for (const Format& format : Formats())
  {
    endings.emplace_back(format.Ending);
  }
  return endings;
}

std::vector<double> TimesOf(vtkDataObject* data)
{
  vtkInformation* const information = data->GetInformation();
  const auto key = vtkStreamingDemandDrivenPipeline::TIME_STEPS();
  const double* const times = information->Has(key) ? information->Get(key) : nullptr;
  return times ? std::vector<double>(times, times + information->Length(key))
               : std::vector<double>();
}

vtkSmartPointer<vtkDataObject> ReadFile(const std::string& path)
{
  CheckRegular(path);
  const ReadFunction read = ReaderFor(path);
  const std::string early = DamagedFile(path, EndingOf(path));
  if (!early.empty())
  {
    FailDamaged(path, early);
  }
  if (vtkSmartPointer<vtkDataObject> empty = EmptyData(path, EndingOf(path)))
  {
    return empty;
  }
  const vtkSmartPointer<vtkDataObject> data = ReadStrictly(path, read);
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
std::vector<SceneProp> ReadProps(const std::string& path)
{
  const vtkSmartPointer<vtkDataObject> data = ReadFile(path);
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

Scene ReadScene(const std::vector<std::string>& paths)
{
  Scene scene;
  scene.FromFiles = true;
  for (std::size_t i = 0; i < paths.size(); i++)
  {
    Tell("reading " + paths[i]);
    for (SceneProp& prop : ReadProps(paths[i]))
    {
      prop.Label = paths[i];
      prop.Index = static_cast<int>(i);
      scene.Props.push_back(prop);
    }
  }
  return scene;
}
}
