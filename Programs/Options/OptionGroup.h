// SPDX-License-Identifier: BSD-3-Clause
// Declares and parses the options of a program, on CLI11, with messages of one line.
#ifndef WideFoVOptionGroup_h
#define WideFoVOptionGroup_h

#include "Scenes/Look.h"
#include "Text/OptionValues.h"

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

// CLI11 is all header: only what declares options is to compile it.
namespace CLI
{
class App;
class Option;
}

namespace widefov
{
// Declares options of one group. Every target must outlive the parsing.
class OptionGroup
{
public:
  OptionGroup(CLI::App& app, const std::string& title)
    : App(app)
    , Title(title)
  {
  }

  using Setter = std::function<void(const std::string& option, const std::string& text)>;

  CLI::Option* Add(const std::string& name, const std::string& type, const std::string& standard,
    const std::string& text, const Setter& set);
  void Number(const std::string& name, const std::string& type, double& target, const Range& range,
    const std::string& text);
  void Integer(const std::string& name, int& target, int low, int high, const std::string& text);
  void Vector(const std::string& name, std::optional<Vector3>& target, const std::string& standard,
    const std::string& text);
  void Choice(const std::string& name, std::string& target, const std::vector<std::string>& choices,
    const std::vector<Alias>& aliases, const std::string& text);

  // Names with commas between them, each one of the choices; the target is what is
  // given, in that order and each once.
  void Choices(const std::string& name, std::vector<std::string>& target,
    const std::vector<std::string>& choices, const std::string& text);
  void Name(
    const std::string& name, const std::string& type, std::string& target, const std::string& text);

  // WIDTHxHEIGHT in pixels.
  void Size(const std::string& name, std::array<int, 2>& target, const std::string& text);
  void Size(const std::string& name, std::optional<std::array<int, 2>>& target,
    const std::string& standard, const std::string& text);

  void Flag(const std::string& name, bool& target, const std::string& text);

  // Switches off what is usual.
  void Off(const std::string& name, bool& target, const std::string& text);

private:
  CLI::App& App;
  std::string Title;
};

// Throws a Failure with ExitUsage; returns an exit code where nothing is left to do
// (--help was printed).
std::optional<int> ParseCommandLine(CLI::App& app, int argc, char** argv);
}

#endif
