// SPDX-License-Identifier: BSD-3-Clause
#include "SmallFile.h"

#include "Text/Messages.h"

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace widefov
{
namespace
{
// Bytes: configurations and calibrations are some hundred.
constexpr std::uintmax_t LargestFile = 1 << 20;
}

std::string ReadSmallFile(const std::string& path, const std::string& advice)
{
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error))
  {
    Fail(path + " is not there, or no file; " + advice);
  }
  if (std::filesystem::file_size(path, error) > LargestFile || error)
  {
    Fail(path + " is too large; " + advice);
  }
  std::ifstream file(path, std::ios::binary);
  std::string text{ std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>() };
  if (!file)
  {
    Fail(path + " cannot be read; check its permissions");
  }
  return text;
}
}
