// SPDX-License-Identifier: BSD-3-Clause
#include "FilmIdentity.h"

#include "Text/Messages.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <map>
#include <set>
#include <sstream>

namespace widefov
{
namespace
{
constexpr char Beginning[] = "Frame of widefov-render ";

// Options that leave the frames as they are, or name files of other options.
const std::set<std::string> Others{ "--part", "--resume", "--strict", "--quiet", "--verbose",
  "--output", "--stats", "--config", "--audio" };

// The value of an option; files are named without their folders.
std::string ValueOf(const CLI::Option& option, const std::string& value)
{
  const bool file =
    option.get_name() == "FILE" || option.get_type_name().find("FILE") != std::string::npos;
  return OneLine(file ? value.substr(value.rfind('/') + 1) : value);
}

// Option -> value, and "version" -> that of the program. None if a text is no identity.
std::map<std::string, std::string> Parse(const std::string& text)
{
  std::map<std::string, std::string> values;
  std::istringstream lines(text);
  std::string line;
  const std::string beginning = Beginning;
  if (!std::getline(lines, line) || line.compare(0, beginning.size(), beginning) != 0)
  {
    return values;
  }
  values["the version"] = line.substr(beginning.size());
  while (std::getline(lines, line))
  {
    const std::size_t blank = std::min(line.find(' '), line.size());
    values[line.substr(0, blank)] = line.substr(std::min(blank + 1, line.size()));
  }
  return values;
}

std::string Told(const std::map<std::string, std::string>& values, const std::string& name)
{
  const auto found = values.find(name);
  return found == values.end() ? "not given" : found->second.empty() ? "given" : found->second;
}
}

std::string FilmIdentity(const CLI::App& app)
{
  std::set<std::string> lines;
  for (const CLI::Option* const option : app.get_options())
  {
    const std::string name = option->get_name();
    if (option->count() == 0 || Others.count(name) > 0)
    {
      continue;
    }
    std::string line = name;
    for (const std::string& value : option->results())
    {
      line += " " + ValueOf(*option, value);
    }
    lines.insert(line);
  }
  std::string text = Beginning + std::string(WIDEFOV_VERSION);
  for (const std::string& line : lines)
  {
    text += "\n" + line;
  }
  return text;
}

std::string FilmDifference(const std::string& here, const std::string& there)
{
  const std::map<std::string, std::string> mine = Parse(here);
  const std::map<std::string, std::string> theirs = Parse(there);
  if (theirs.empty())
  {
    return "it does not say which options it was drawn with";
  }
  std::map<std::string, std::string> all = mine;
  all.insert(theirs.begin(), theirs.end());
  for (const auto& entry : all)
  {
    const std::string& name = entry.first;
    const bool same = mine.count(name) == theirs.count(name) && mine.at(name) == theirs.at(name);
    if (!same)
    {
      return name + " is " + Told(mine, name) + ", and " + Told(theirs, name) + " there";
    }
  }
  return "";
}
}
