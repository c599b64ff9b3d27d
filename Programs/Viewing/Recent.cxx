// SPDX-License-Identifier: BSD-3-Clause
#include "Recent.h"

#include "System/OutputFiles.h"
#include "Text/Messages.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace widefov
{
namespace
{
constexpr std::size_t MostKept = 12;

std::string Environment(const char* name)
{
  const char* const value = std::getenv(name);
  return value != nullptr ? value : "";
}
}

std::string Recent::UsualFile()
{
  const std::string state = Environment("XDG_STATE_HOME");
  const std::string home = Environment("HOME");
  if (state.empty() && home.empty())
  {
    return "";
  }
  return (state.empty() ? home + "/.local/state" : state) + "/widefov/recent";
}

Recent::Recent(const std::string& file)
  : File(file)
{
}

std::vector<std::string> Recent::Get() const
{
  std::vector<std::string> paths;
  std::ifstream stream(this->File);
  for (std::string line; paths.size() < MostKept && std::getline(stream, line);)
  {
    std::error_code error;
    if (!line.empty() && std::filesystem::is_regular_file(line, error))
    {
      paths.push_back(line);
    }
  }
  return paths;
}

void Recent::Add(const std::vector<std::string>& paths)
{
  if (this->File.empty())
  {
    return;
  }
  std::vector<std::string> all = this->Get();
  for (const std::string& path : paths)
  {
    std::error_code error;
    const std::string whole = std::filesystem::absolute(path, error).string();
    all.erase(std::remove(all.begin(), all.end(), whole), all.end());
    if (!error && whole.find('\n') == std::string::npos)
    {
      all.insert(all.begin(), whole);
    }
  }
  std::string text;
  for (std::size_t i = 0; i < std::min(all.size(), MostKept); i++)
  {
    text += all[i] + "\n";
  }
  try
  {
    std::error_code error;
    std::filesystem::create_directories(std::filesystem::path(this->File).parent_path(), error);
    OutputFiles files;
    files.Write(this->File, text.data(), text.size());
    files.Commit();
  }
  catch (const Failure&)
  {
    return; // the data are shown all the same
  }
}
}
