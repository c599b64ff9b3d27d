// SPDX-License-Identifier: BSD-3-Clause
#include "FileText.h"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <fstream>

namespace wfv::displays
{
namespace
{
bool IsBlank(char c)
{
  return c == ' ' || c == '\t' || c == '\r' || c == '\n';
}

void SkipBlanks(std::string_view& text)
{
  std::size_t count = 0;
  while (count < text.size() && IsBlank(text[count]))
  {
    count++;
  }
  text.remove_prefix(count);
}
}

std::string ReadBytes(const std::string& path)
{
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error))
  {
    throw FileError(path + " is not there, or no file; check the name");
  }
  const auto size = std::filesystem::file_size(path, error);
  if (error || size > LargestFile)
  {
    throw FileError(path + " is larger than 1 GiB: it is no calibration; check the name");
  }
  std::ifstream file(path, std::ios::binary);
  std::string bytes;
  bytes.reserve(size);
  std::array<char, 1 << 16> part; // (a text of this size would be filled with zeros first)
  while (file.read(part.data(), part.size()) || file.gcount() > 0)
  {
    bytes.append(part.data(), static_cast<std::size_t>(file.gcount()));
  }
  if (bytes.size() != size)
  {
    throw FileError(path + " cannot be read; check its permissions");
  }
  return bytes;
}

std::string_view Trimmed(std::string_view text)
{
  SkipBlanks(text);
  while (!text.empty() && IsBlank(text.back()))
  {
    text.remove_suffix(1);
  }
  return text;
}

std::string LowerCase(std::string_view text)
{
  std::string lower(text);
  std::transform(lower.begin(), lower.end(), lower.begin(),
    [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return lower;
}

std::size_t CountOf(double value)
{
  const bool whole = value >= 1 && value <= double(LargestCount) && value == std::floor(value);
  return whole ? static_cast<std::size_t>(value) : 0;
}

std::array<std::size_t, 2> GridSize(const Lines& lines)
{
  const std::array<double, 2> said = lines.Finite<2>("the columns and rows of the mesh");
  const std::array<std::size_t, 2> size{ CountOf(said[0]), CountOf(said[1]) };
  if (size[0] < 2 || size[1] < 2 || size[0] * size[1] > LargestCount)
  {
    lines.Fail("is no size of a mesh, which has 2 columns and rows at least");
  }
  return size;
}

void CheckNodeCount(const std::string& path, std::size_t there, std::size_t all)
{
  if (there < all)
  {
    throw FileError(path + " ends after " + std::to_string(there) + " of " + std::to_string(all) +
      " nodes: it is cut; get the whole file");
  }
}

bool Numbers::Next(double& value)
{
  std::string_view text = this->Rest;
  SkipBlanks(text);
  if (text.size() > 1 && text[0] == '+' && text[1] != '-')
  {
    text.remove_prefix(1); // from_chars knows no plus
  }
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc())
  {
    return false;
  }
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  const bool apart = text.empty() || IsBlank(text[0]) || text[0] == this->Separator;
  if (!apart)
  {
    return false;
  }
  SkipBlanks(text);
  if (!text.empty() && text[0] == this->Separator)
  {
    text.remove_prefix(1);
  }
  this->Rest = text;
  return true;
}

std::string_view Numbers::Remainder() const
{
  return Trimmed(this->Rest);
}

bool Lines::Next()
{
  while (!this->Rest.empty())
  {
    const std::size_t end = std::min(this->Rest.find('\n'), this->Rest.size());
    this->Line = Trimmed(this->Rest.substr(0, end));
    this->Rest.remove_prefix(std::min(end + 1, this->Rest.size()));
    this->Number++;
    if (!this->Line.empty())
    {
      return true;
    }
  }
  return false;
}

void Lines::Fail(const std::string& problem) const
{
  throw FileError(this->Path + ", line " + std::to_string(this->Number) + ": " + problem);
}
}
