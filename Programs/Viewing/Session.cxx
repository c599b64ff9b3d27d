// SPDX-License-Identifier: BSD-3-Clause
#include "Session.h"

#include "Options/Displays.h"
#include "System/OutputFiles.h"
#include "Text/Messages.h"

#include <algorithm>
#include <filesystem>

namespace widefov
{
namespace
{
// Options that name files.
const std::vector<std::string> OfFiles{ "FILE", "--direction-map", "--lens-file", "--sky",
  "--screens", "--pose", "--poses" };

std::string ValueOf(const Setting& setting)
{
  const std::vector<std::string> displays = DisplayNames(); // beside files of direction maps
  const bool file = std::find(OfFiles.begin(), OfFiles.end(), setting.Option) != OfFiles.end() &&
    std::find(displays.begin(), displays.end(), setting.Value) == displays.end();
  std::string value =
    file ? std::filesystem::absolute(setting.Value).lexically_normal().string() : setting.Value;
  if (value.find_first_of("\n\r") != std::string::npos)
  {
    Fail(setting.Option + " has a line break, which a file of options cannot hold; rename it");
  }
  return value;
}
}

std::string SessionText(const std::vector<Setting>& settings)
{
  std::string text =
    "# widefov-viewer --session reads this, and any of both programs by --config\n";
  for (const Setting& setting : settings)
  {
    text += setting.Option == "FILE" ? "file" : setting.Option.substr(2);
    // quotes keep blanks and quotes at the ends
    text += setting.Value.empty() ? "\n" : " = \"" + ValueOf(setting) + "\"\n";
  }
  return text;
}

void WriteSession(const std::string& path, const std::vector<Setting>& settings)
{
  const std::string text = SessionText(settings);
  CheckWritable(path);
  OutputFiles files;
  files.Write(path, text.data(), text.size());
  files.Commit();
}
}
