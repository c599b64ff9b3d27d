// SPDX-License-Identifier: BSD-3-Clause
// widefov-run: starts a program so that the VTK in it makes wide renderers, cameras and mappers.
#include "Options/OptionGroup.h"
#include "Run/Wishes/Wishes.h"
#include "Text/Messages.h"

#include <CLI/CLI.hpp>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <map>
#include <unistd.h>

namespace
{
using namespace widefov;

struct CommandLine
{
  std::map<std::string, std::string> Values; // by variable
  std::vector<std::string> Program;          // and its arguments
};

void Declare(CLI::App& app, CommandLine& line)
{
  for (const Wish& wish : AllWishes())
  {
    std::string& value = line.Values[wish.Variable];
    const auto set = [&value](const std::string& text) { value = text; };
    if (*wish.Type == 0)
    {
      app.add_flag_callback(
        wish.Option, [&value] { value = "1"; }, wish.Text);
      continue;
    }
    app.add_option_function<std::string>(wish.Option, set, wish.Text)->type_name(wish.Type);
  }
  app.set_version_flag("--version", std::string("widefov-run ") + WIDEFOV_VERSION);
  app.prefix_command();
  app.footer("PROGRAM [ARGUMENT...] follows the options: widefov-run --inside python3 program.py");
}

std::optional<int> Parse(int argc, char** argv, CommandLine& line)
{
  CLI::App app("Runs a program that draws with VTK, and shows wide views in it.", "widefov-run");
  Declare(app, line);
  if (const std::optional<int> done = ParseCommandLine(app, argc, argv))
  {
    return done;
  }
  line.Program = app.remaining();
  if (!line.Program.empty() && line.Program.front() == "--")
  {
    line.Program.erase(line.Program.begin());
  }
  if (line.Program.empty())
  {
    FailUsage("name the program to run; widefov-run --help lists the options");
  }
  if (line.Program.front().front() == '-')
  {
    FailUsage("there is no option " + line.Program.front() + "; widefov-run --help lists them");
  }
  return std::nullopt;
}

// Ahead of what is there already.
void Prepend(const char* variable, const std::filesystem::path& folder)
{
  const char* const before = std::getenv(variable);
  const std::string more = before && *before ? std::string(":") + before : std::string();
  setenv(variable, (folder.string() + more).c_str(), 1);
}

std::optional<std::string> ValueOf(const CommandLine& line, const Wish& wish)
{
  const std::string& value = line.Values.at(wish.Variable);
  return value.empty() ? std::nullopt : std::optional<std::string>(value);
}

void SetEnvironment(const CommandLine& line)
{
  ReadWishes([&](const Wish& wish) { return ValueOf(line, wish); }, &Wish::Option);
  for (const Wish& wish : AllWishes())
  {
    if (const std::optional<std::string> value = ValueOf(line, wish))
    {
      setenv(wish.Variable, value->c_str(), 1);
    }
  }
  const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe");
  const std::filesystem::path folder = self.parent_path() / WIDEFOV_RUN_FOLDER;
  const std::filesystem::path made = folder.lexically_normal();
  for (const char* file : { "widefov-overrides.so", "vtk/widefov-loader.so" })
  {
    if (!std::filesystem::exists(made / file)) // the program would be as flat as ever
    {
      Fail("there is no " + (made / file).string() + ", which makes the views wide");
    }
  }
  Prepend("VTK_AUTOLOAD_PATH", made / "vtk");
  Prepend("PYTHONPATH", made / "python");
}

[[noreturn]] void Start(const std::vector<std::string>& program)
{
  std::vector<char*> arguments;
  for (const std::string& argument : program)
  {
    arguments.push_back(const_cast<char*>(argument.c_str()));
  }
  arguments.push_back(nullptr);
  execvp(arguments[0], arguments.data());
  Fail("the program '" + program.front() + "' cannot be run: " + std::strerror(errno));
}

int Run(int argc, char** argv)
{
  CommandLine line;
  if (const std::optional<int> done = Parse(argc, argv, line))
  {
    return *done;
  }
  SetEnvironment(line);
  Start(line.Program);
}
}

// Without RunProgram: the program inherits what this one ignores of signals.
int main(int argc, char** argv)
{
  SetProgramName("widefov-run");
  try
  {
    return Run(argc, argv);
  }
  catch (const Failure& failure)
  {
    SayError(failure.what());
    return failure.ExitCode;
  }
  catch (const std::exception& error)
  {
    SayError(std::string("unexpected: ") + error.what() + "; please report it");
  }
  return ExitFailed;
}
