// SPDX-License-Identifier: BSD-3-Clause
#include "Calibration.h"

#include "FileText.h"
#include "Readers.h"

#include <filesystem>
#include <map>

namespace wfv::displays
{
namespace
{
using OneReader = Calibration (*)(const std::string& path, const std::string& bytes);

const std::map<std::string, OneReader> OneProjector{ { ".data", ReadBourke },
  { ".obj", ReadObjWarp }, { ".pfm", ReadPfmWarp }, { ".sgc", ReadSciss }, { ".txt", ReadSkySkan },
  { ".skyskan", ReadSkySkan }, { ".ol", ReadScalable }, { ".csv", ReadDomeprojection } };

std::vector<Calibration> ReadAll(const std::string& path)
{
  const std::string ending = LowerCase(std::filesystem::path(path).extension().string());
  if (ending == ".mpcdi")
  {
    return ReadMpcdiArchive(path);
  }
  if (ending == ".xml" || ending == ".simcad")
  {
    return ReadXml(path, ReadBytes(path));
  }
  const auto reader = OneProjector.find(ending);
  if (reader == OneProjector.end())
  {
    throw FileError(path + " has an ending of no calibration: .mpcdi, .xml, .data, .obj, .pfm, " +
      ".sgc, .txt, .ol or .csv");
  }
  std::vector<Calibration> one; // (a list in braces would copy it)
  one.push_back(reader->second(path, ReadBytes(path)));
  return one;
}
}

Calibration ReadCalibration(const std::string& path, const std::string& name)
{
  std::vector<Calibration> all = ReadCalibrations(path);
  std::string names;
  for (Calibration& calibration : all)
  {
    if (calibration.Name == name || (name.empty() && all.size() == 1))
    {
      return std::move(calibration);
    }
    names += (names.empty() ? "" : ", ") + calibration.Name;
  }
  if (names.empty())
  {
    throw FileError(path + " has one projector, which has no name; leave " + name + " out");
  }
  throw FileError(path + " has the regions " + names + "; name one of them" +
    (name.empty() ? "" : ", not " + name));
}

std::vector<Calibration> ReadCalibrations(const std::string& path)
{
  std::vector<Calibration> all = ReadAll(path);
  for (Calibration& calibration : all)
  {
    calibration.Path = path;
  }
  return all;
}
}
