// SPDX-License-Identifier: BSD-3-Clause
#include "OutputNames.h"

#include "StereoChoice.h"
#include "StereoLayout.h"
#include "System/OutputFiles.h"
#include "Text/Messages.h"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <filesystem>

namespace widefov
{
namespace
{
struct Format
{
  const char* Ending;
  const char* Writer; // OpenImageIO's name
};

const std::vector<Format> Formats{ { ".png", "png" }, { ".jpg", "jpeg" }, { ".jpeg", "jpeg" },
  { ".tif", "tiff" }, { ".tiff", "tiff" }, { ".exr", "openexr" } };

std::string WithSuffix(const std::string& path, const std::string& suffix)
{
  std::filesystem::path file(path);
  return file.replace_filename(file.stem().string() + suffix + file.extension().string()).string();
}

// picture-SCREEN.png
std::string NameOfScreen(const Options& sight, const std::string& path)
{
  return sight.Screen ? WithSuffix(path, "-" + sight.Screen->Name) : path;
}

// picture-PROJECTOR.png
std::string NameOfProjector(const Options& o, const std::string& path)
{
  return o.ProjectorName.empty() ? path : WithSuffix(path, "-" + o.ProjectorName);
}

// picture-0007.png
std::string NameOfPose(const Options& sight, const std::string& path)
{
  if (!sight.Number)
  {
    return path;
  }
  char number[32];
  std::snprintf(number, sizeof(number), "-%04zu", *sight.Number);
  return WithSuffix(path, number);
}
}

std::string WriterFor(const std::string& path)
{
  if (path == StandardStream)
  {
    return "png";
  }
  std::string ending = std::filesystem::path(path).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const auto format = std::find_if(
    Formats.begin(), Formats.end(), [&](const Format& f) { return ending == f.Ending; });
  return format == Formats.end() ? "" : format->Writer;
}

void CheckPictureName(const std::string& path)
{
  if (WriterFor(path).empty())
  {
    FailUsage("--output: '" + path + "' does not end in .png, .jpg, .tif or .exr; choose one");
  }
}

void CheckAovName(const std::string& path)
{
  if (WriterFor(path) != "openexr")
  {
    FailUsage("--aov: '" + path + "' does not end in .exr; rename it");
  }
}

bool IsMultiViewName(const std::string& path)
{
  return WriterFor(path) == "openexr";
}

bool IsVr180Photo(const std::string& path)
{
  const std::filesystem::path file(path);
  return WriterFor(path) == "jpeg" && file.stem().extension() == ".vr";
}

std::vector<std::string> FilesOf(const Options& o, const std::string& output)
{
  const StereoLayout& layout = FindStereoLayout(o.Layout);
  const std::string name = NameOfProjector(o, NameOfScreen(o, output));
  if (!HasTwoEyes(o) || !layout.Separate)
  {
    return { NameOfPose(o, name) };
  }
  return { NameOfPose(o, FileOfEye(layout, name, 0)), NameOfPose(o, FileOfEye(layout, name, 1)) };
}
}
