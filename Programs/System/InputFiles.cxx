// SPDX-License-Identifier: BSD-3-Clause
#include "InputFiles.h"

#include "Text/Messages.h"

#include <algorithm>
#include <filesystem>
#include <mutex>
#include <set>

namespace widefov
{
namespace
{
struct InputSet
{
  std::mutex Mutex;
  std::set<std::string> Names;
};

// Never destroyed: threads may read files when the program ends.
InputSet& Inputs()
{
  static auto* const inputs = new InputSet;
  return *inputs;
}
}

std::string PlainName(const std::string& path)
{
  std::error_code error;
  const std::filesystem::path plain =
    std::filesystem::weakly_canonical(std::filesystem::absolute(path, error), error);
  return error ? path : plain.string();
}

void NoteInput(const std::string& path)
{
  if (path.empty())
  {
    return;
  }
  const std::string plain = PlainName(path);
  const std::lock_guard<std::mutex> lock(Inputs().Mutex);
  Inputs().Names.insert(plain);
}

std::vector<std::string> NotedInputs()
{
  const std::lock_guard<std::mutex> lock(Inputs().Mutex);
  return { Inputs().Names.begin(), Inputs().Names.end() };
}

void CheckNoInput(const std::string& path)
{
  const std::vector<std::string> inputs = NotedInputs();
  bool found = std::binary_search(inputs.begin(), inputs.end(), PlainName(path));
  std::error_code error;
  const std::uintmax_t links = std::filesystem::hard_link_count(path, error);
  for (std::size_t i = 0; !error && links > 1 && i < inputs.size(); i++)
  {
    std::error_code other;
    found = found || std::filesystem::equivalent(path, inputs[i], other);
  }
  if (found)
  {
    Fail(path + " is an input file; write somewhere else");
  }
}
}
