// SPDX-License-Identifier: BSD-3-Clause
#include "Completion.h"

#include "Text/OptionValues.h"

#include <CLI/CLI.hpp>

#include <algorithm>

namespace widefov
{
namespace
{
// One branch a kind of option: names, files, or nothing that can be known.
std::string Branch(const std::string& option, const std::string& reply)
{
  return "    " + option + ")\n      " + reply + "\n      return ;;\n";
}

bool TakesFile(const CLI::Option& option)
{
  const std::string type = option.get_type_name();
  return type.rfind("FILE", 0) == 0 || type.rfind("DIR", 0) == 0;
}

std::string Names(const CLI::Option& option)
{
  std::string names;
  for (const std::string& name : option.get_snames())
  {
    names += (names.empty() ? "-" : "|-") + name;
  }
  for (const std::string& name : option.get_lnames())
  {
    names += (names.empty() ? "--" : "|--") + name;
  }
  return names;
}

std::string Branches(const CLI::App& app)
{
  std::string text;
  for (const CLI::Option* option : app.get_options())
  {
    const std::string names = Names(*option);
    if (option->get_lnames().empty() || option->get_items_expected_max() == 0)
    {
      continue;
    }
    const auto words = Completions().find("--" + option->get_lnames().front());
    text += Branch(names,
      words != Completions().end()
        ? "COMPREPLY=($(compgen -W '" + Join(words->second, " ") + "' -- \"$word\"))"
        : TakesFile(*option) ? "COMPREPLY=($(compgen -f -- \"$word\"))"
                             : "COMPREPLY=()");
  }
  return text;
}
}

std::map<std::string, std::vector<std::string>>& Completions()
{
  static std::map<std::string, std::vector<std::string>> all;
  return all;
}

std::vector<std::string> OptionNames(const CLI::App& app)
{
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options())
  {
    for (const std::string& name : option->get_lnames())
    {
      names.push_back("--" + name);
    }
  }
  return names;
}

std::string BashCompletion(const CLI::App& app)
{
  const std::string name = app.get_name();
  std::string function = "_" + name;
  std::replace(function.begin(), function.end(), '-', '_');
  return "# bash completion of " + name + ", written by " + name + " --completion bash\n" +
    function + "()\n{\n  local word=\"${COMP_WORDS[COMP_CWORD]}\"\n" +
    "  case \"${COMP_WORDS[COMP_CWORD - 1]}\" in\n" + Branches(app) + "  esac\n" +
    "  if [[ $word == -* ]]; then\n    COMPREPLY=($(compgen -W '" + Join(OptionNames(app), " ") +
    "' -- \"$word\"))\n  else\n    COMPREPLY=($(compgen -f -- \"$word\"))\n  fi\n}\n" +
    "complete -o filenames -F " + function + " " + name + "\n";
}
}
