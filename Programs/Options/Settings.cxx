// SPDX-License-Identifier: BSD-3-Clause
#include "Settings.h"

#include "Completion.h"
#include "OptionGroup.h"
#include "Text/Messages.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace widefov
{
namespace
{
// What stands for nothing else in a file: these print instead of drawing, or name the file itself.
const std::vector<std::string> CommandLineOnly{ "--help", "--config", "--version", "--completion",
  "--session" };

// Of a line that says nothing: it may be that of a binary file.
constexpr std::size_t LongestQuote = 60;

// Of those in one row the command line gives one at the most.
const std::vector<std::vector<std::string>> Rivals{ { "FILE", "--scene" },
  { "--look-at", "--direction" }, { "--fov", "--hfov" }, { "--fov", "--vfov" },
  { "--quiet", "--verbose" }, { "--inside", "--outside" }, { "--inside", "--eye" },
  { "--outside", "--eye" } };

bool IsGiven(const CLI::App& app, const std::string& name)
{
  const CLI::Option* const option = app.get_option_no_throw(name);
  return option != nullptr && option->count() > 0;
}

bool IsDecided(const CLI::App& app, const std::string& name)
{
  if (IsGiven(app, name))
  {
    return true;
  }
  return std::any_of(Rivals.begin(), Rivals.end(), [&](const std::vector<std::string>& row) {
    return std::find(row.begin(), row.end(), name) != row.end() &&
      std::any_of(
        row.begin(), row.end(), [&](const std::string& other) { return IsGiven(app, other); });
  });
}

std::string Trimmed(const std::string& text)
{
  const std::size_t begin = text.find_first_not_of(" \t\r");
  return begin == std::string::npos
    ? ""
    : text.substr(begin, text.find_last_not_of(" \t\r") - begin + 1);
}

// "NAME" or "name" for "--name"; data are "file".
std::string OptionOf(std::string key)
{
  key.erase(0, key.find_first_not_of('-'));
  for (char& c : key)
  {
    c = c == '_' ? '-' : c;
  }
  return key == "file" ? "FILE" : "--" + key;
}

CLI::Option* Find(CLI::App& app, const Setting& setting)
{
  CLI::Option* const option = app.get_option_no_throw(setting.Option);
  const auto& barred = CommandLineOnly;
  if (std::find(barred.begin(), barred.end(), setting.Option) != barred.end())
  {
    FailUsage(setting.Where + setting.Option + " is for the command line; take it out");
  }
  if (option == nullptr)
  {
    FailUsage(setting.Where + "there is no option " + setting.Option +
      DidYouMean(NearestName(setting.Option, OptionNames(app))) + "; " + app.get_name() +
      " --help lists them");
  }
  return option;
}

// The value for CLI11; none where it is a flag that is not to be set.
std::vector<std::string> ValueFor(const CLI::Option& option, const Setting& setting)
{
  if (option.get_items_expected_max() != 0)
  {
    return { setting.Value };
  }
  const std::string yes = Choose(setting.Where + setting.Option,
    setting.Value.empty() ? "true" : setting.Value, { "true", "false" },
    { { "yes", "true" }, { "on", "true" }, { "1", "true" }, { "no", "false" }, { "off", "false" },
      { "0", "false" } });
  return yes == "true" ? std::vector<std::string>{ yes } : std::vector<std::string>{};
}

// Sets it from everything that was collected for it.
void Set(CLI::Option& option, const std::string& where)
{
  try
  {
    option.run_callback();
  }
  catch (const Failure& failure)
  {
    throw Failure(failure.ExitCode, where + failure.what());
  }
  catch (const CLI::ParseError& error)
  {
    FailUsage(where + error.what());
  }
}

Setting ParseLine(const std::string& line, const std::string& where)
{
  const std::size_t sign = line.find('=');
  const std::string key = Trimmed(line.substr(0, sign));
  if (key.empty() || key.find_first_of(" \t") != std::string::npos)
  {
    FailUsage(where + "'" + line.substr(0, LongestQuote) + "' is not of the form NAME = VALUE");
  }
  std::string value = sign == std::string::npos ? "" : Trimmed(line.substr(sign + 1));
  const bool quoted =
    value.size() > 1 && (value[0] == '"' || value[0] == '\'') && value.back() == value[0];
  return { OptionOf(key), quoted ? value.substr(1, value.size() - 2) : value, where };
}
}

void ApplySettings(CLI::App& app, const std::vector<Setting>& settings)
{
  // decided by what was given before: an option may stand in a file several times
  std::vector<std::pair<CLI::Option*, const Setting*>> set;
  for (const Setting& setting : settings)
  {
    CLI::Option* const option = Find(app, setting);
    if (!IsDecided(app, setting.Option))
    {
      set.emplace_back(option, &setting);
    }
  }
  for (const auto& [option, setting] : set)
  {
    const std::vector<std::string> value = ValueFor(*option, *setting);
    if (!value.empty())
    {
      option->add_result(value);
    }
  }
  for (auto one = set.begin(); one != set.end(); ++one)
  {
    const bool again =
      std::any_of(set.begin(), one, [&](auto& s) { return s.first == one->first; });
    if (!again && one->first->count() > 0)
    {
      Set(*one->first, one->second->Where);
    }
  }
}

std::vector<Setting> ReadSettings(const std::string& path)
{
  std::error_code error;
  if (std::filesystem::is_directory(path, error))
  {
    Fail(path + " is a folder; name a file of options");
  }
  errno = 0;
  std::ifstream file(path);
  if (!file)
  {
    Fail(path + " cannot be opened: " + std::strerror(errno) + "; check the name");
  }
  std::vector<Setting> settings;
  std::string line;
  for (int number = 1; std::getline(file, line); number++)
  {
    const std::string where = path + ", line " + std::to_string(number) + ": ";
    const std::string text = Trimmed(line);
    if (!text.empty() && text[0] != '#')
    {
      settings.push_back(ParseLine(text, where));
    }
  }
  return settings;
}
}
