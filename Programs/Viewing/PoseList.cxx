// SPDX-License-Identifier: BSD-3-Clause
#include "PoseList.h"

#include "System/OutputFiles.h"
#include "Text/Messages.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace widefov
{
namespace
{
std::string LineOf(const Vector3& eye, const Vector3& direction, const Vector3& up)
{
  std::string line;
  for (const Vector3& v : { eye, direction, up })
  {
    for (const double value : v)
    {
      char text[64];
      std::snprintf(text, sizeof(text), "%.17g", value);
      line += (line.empty() ? "" : " ") + std::string(text);
    }
  }
  return line + "\n";
}
}

std::size_t AppendPose(
  const std::string& path, const Vector3& eye, const Vector3& direction, const Vector3& up)
{
  CheckWritable(path);
  std::string all;
  std::error_code error;
  if (std::filesystem::exists(path, error))
  {
    std::ifstream file(path, std::ios::binary);
    all.assign(std::istreambuf_iterator<char>(file), {});
    if (!file)
    {
      Fail(path + " cannot be read; choose another file by --poses");
    }
  }
  all += all.empty() || all.back() == '\n' ? "" : "\n";
  all += LineOf(eye, direction, up);
  OutputFiles files; // whole or not at all
  files.Write(path, all.data(), all.size());
  files.Commit();
  return static_cast<std::size_t>(std::count(all.begin(), all.end(), '\n'));
}
}
