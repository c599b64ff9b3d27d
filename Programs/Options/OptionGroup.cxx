// SPDX-License-Identifier: BSD-3-Clause
#include "OptionGroup.h"

#include "Completion.h"
#include "Text/Messages.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>

namespace widefov
{
namespace
{
// Of --help, where the texts begin: behind the longest names that share a line with theirs.
constexpr std::size_t HelpColumn = 34;

constexpr double Most = 1e18; // squares of it still fit a float32

void ParseSize(const std::string& option, const std::string& text, std::array<int, 2>& size)
{
  constexpr int Largest = 1 << 24; // the display's own limit is asked later
  const std::size_t cross = text.find('x');
  if (cross == std::string::npos)
  {
    FailUsage(option + ": '" + text + "' is not WIDTHxHEIGHT, such as 2048x1024");
  }
  size[0] = ParseInteger(option, text.substr(0, cross), 1, Largest);
  size[1] = ParseInteger(option, text.substr(cross + 1), 1, Largest);
}

// Of what CLI11 could not place; an option's value is no part of its name.
std::string FirstUnknown(const CLI::App& app)
{
  const std::vector<std::string> all = app.remaining();
  const std::string first = all.empty() ? "" : all.front();
  return first.substr(0, first.find('='));
}
}

CLI::Option* OptionGroup::Add(const std::string& name, const std::string& type,
  const std::string& standard, const std::string& text, const Setter& set)
{
  const std::string last = name.substr(name.rfind(',') + 1);
  return this->App
    .add_option_function<std::string>(
      name, [last, set](const std::string& value) { set(last, value); }, text)
    ->type_name(type)
    ->default_str(standard)
    ->group(this->Title);
}

void OptionGroup::Number(const std::string& name, const std::string& type, double& target,
  const Range& range, const std::string& text)
{
  this->Add(name, type, Text(target), text + ", " + range.Describe(),
    [&target, range](const std::string& option, const std::string& value) {
      target = ParseNumber(option, value, range);
    });
}

void OptionGroup::Integer(
  const std::string& name, int& target, int low, int high, const std::string& text)
{
  const std::string range = Range{ double(low), double(high) }.Describe();
  this->Add(name, "N", std::to_string(target), text + ", " + range,
    [&target, low, high](const std::string& option, const std::string& value) {
      target = ParseInteger(option, value, low, high);
    });
}

void OptionGroup::Vector(const std::string& name, std::optional<Vector3>& target,
  const std::string& standard, const std::string& text)
{
  this->Add(
    name, "X,Y,Z", standard, text, [&target](const std::string& option, const std::string& value) {
      const std::vector<double> v = ParseNumbers(option, value, 3, 3);
      for (const double component : v)
      {
        if (std::abs(component) > Most)
        {
          FailUsage(option + ": '" + value + "' is beyond 1e18");
        }
      }
      target = Vector3{ { v[0], v[1], v[2] } };
    });
}

void OptionGroup::Choice(const std::string& name, std::string& target,
  const std::vector<std::string>& choices, const std::vector<Alias>& aliases,
  const std::string& text)
{
  this->Add(name, "NAME", target, text + ": " + Join(choices),
    [&target, choices, aliases](const std::string& option, const std::string& value) {
      target = Choose(option, value, choices, aliases);
    });
  Completions()[name] = choices;
}

void OptionGroup::Name(
  const std::string& name, const std::string& type, std::string& target, const std::string& text)
{
  this->Add(
    name, type, target, text, [&target](const std::string& option, const std::string& value) {
      if (value.empty())
      {
        FailUsage(option + " needs a name, not an empty text");
      }
      target = value;
    });
}

void OptionGroup::Flag(const std::string& name, bool& target, const std::string& text)
{
  this->App.add_flag(name, target, text)->group(this->Title);
}

void OptionGroup::Off(const std::string& name, bool& target, const std::string& text)
{
  this->App
    .add_flag_callback(
      name, [&target] { target = false; }, text)
    ->group(this->Title);
}

void OptionGroup::Size(const std::string& name, std::array<int, 2>& target, const std::string& text)
{
  this->Add(name, "WxH", std::to_string(target[0]) + "x" + std::to_string(target[1]), text,
    [&target](
      const std::string& option, const std::string& value) { ParseSize(option, value, target); });
}

void OptionGroup::Size(const std::string& name, std::optional<std::array<int, 2>>& target,
  const std::string& standard, const std::string& text)
{
  this->Add(
    name, "WxH", standard, text, [&target](const std::string& option, const std::string& value) {
      target.emplace();
      ParseSize(option, value, *target);
    });
}

void OptionGroup::Choices(const std::string& name, std::vector<std::string>& target,
  const std::vector<std::string>& choices, const std::string& text)
{
  this->Add(name, "A,B,..", Join(target, ","), text + ": " + Join(choices),
    [&target, choices](const std::string& option, const std::string& value) {
      target.clear();
      for (std::size_t begin = 0; begin <= value.size();)
      {
        const std::size_t end = std::min(value.find(',', begin), value.size());
        const std::string one = Choose(option, value.substr(begin, end - begin), choices);
        if (std::find(target.begin(), target.end(), one) == target.end())
        {
          target.push_back(one);
        }
        begin = end + 1;
      }
    });
}

std::optional<int> ParseCommandLine(CLI::App& app, int argc, char** argv)
{
  app.get_formatter()->column_width(HelpColumn);
  std::string shell;
  OptionGroup(app, "Output")
    .Choice("--completion", shell, { "bash" }, {}, "print what completes the command line for");
  try
  {
    app.parse(argc, argv);
  }
  catch (const CLI::CallForHelp&)
  {
    Print(app.help());
    return ExitDone;
  }
  catch (const CLI::ExtrasError& error)
  {
    const std::string first = FirstUnknown(app);
    FailUsage(std::string(error.what()) + DidYouMean(NearestName(first, OptionNames(app))) + "; " +
      app.get_name() + " --help lists the options");
  }
  catch (const CLI::ParseError& error)
  {
    FailUsage(std::string(error.what()) + "; " + app.get_name() + " --help lists the options");
  }
  if (!shell.empty())
  {
    Print(BashCompletion(app));
    return ExitDone;
  }
  return std::nullopt;
}
}
