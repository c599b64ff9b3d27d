// SPDX-License-Identifier: BSD-3-Clause
#include "NamedFiles.h"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>

namespace widefov
{
namespace
{
// Bytes: a longer file holds its data itself.
constexpr std::uintmax_t LongestList = 1 << 20;

bool NamesOthers(const std::string& ending)
{
  return ending == ".vtm" || ending == ".gltf" || ending == ".obj" || ending == ".pvtu" ||
    ending == ".pvtp" || ending == ".pvti" || ending == ".pvts" || ending == ".pvtr";
}
}

std::vector<std::string> NamedFiles(const std::string& path)
{
  const std::filesystem::path file(path);
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  if (error || size > LongestList || !NamesOthers(file.extension().string()))
  {
    return {};
  }
  std::ifstream stream(file, std::ios::binary);
  const std::string text{ std::istreambuf_iterator<char>(stream), {} };
  static const std::regex naming("(?:file=|Source=|\"uri\"\\s*:\\s*)\"([^\"]{1,255})\"|"
                                 "mtllib[ \\t]+([^\\r\\n]{1,255})");
  std::vector<std::string> names;
  for (std::sregex_iterator i(text.begin(), text.end(), naming), end; i != end; ++i)
  {
    const std::string name = (*i)[1].matched ? (*i)[1].str() : (*i)[2].str();
    names.push_back((file.parent_path() / name).string());
  }
  return names;
}
}
