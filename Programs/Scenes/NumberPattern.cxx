// SPDX-License-Identifier: BSD-3-Clause
#include "NumberPattern.h"

#include <charconv>
#include <filesystem>
#include <regex>

namespace widefov
{
namespace
{
constexpr std::size_t MostDigits = 18; // what fits a long long
}

std::optional<NumberPattern> NumberPattern::Parse(const std::string& path)
{
  static const std::regex place("%0?([0-9]{0,2})d");
  const std::filesystem::path file(path);
  const std::string name = file.filename().string();
  std::smatch found;
  if (!std::regex_search(name, found, place) || std::regex_search(found.suffix().str(), place))
  {
    return std::nullopt;
  }
  NumberPattern pattern;
  const std::string digits = found[1];
  pattern.Digits = digits.empty() ? 1 : std::stoul(digits);
  if (pattern.Digits > MostDigits)
  {
    return std::nullopt;
  }
  pattern.Before = path.substr(0, path.size() - name.size()) + found.prefix().str();
  pattern.After = found.suffix();
  return pattern;
}

std::string NumberPattern::Name(long long number) const
{
  const std::string digits = std::to_string(number);
  const std::size_t zeros = digits.size() < this->Digits ? this->Digits - digits.size() : 0;
  return this->Before + std::string(zeros, '0') + digits + this->After;
}

std::optional<long long> NumberPattern::NumberIn(const std::string& path) const
{
  const std::size_t around = this->Before.size() + this->After.size();
  if (path.size() <= around || path.size() - around > MostDigits)
  {
    return std::nullopt;
  }
  long long number = 0;
  const char* const begin = path.data() + this->Before.size();
  const char* const end = path.data() + path.size() - this->After.size();
  const auto [stop, error] = std::from_chars(begin, end, number);
  const bool whole = error == std::errc() && stop == end && number >= 0;
  return whole && this->Name(number) == path ? std::optional(number) : std::nullopt;
}
}
