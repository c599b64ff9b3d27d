// SPDX-License-Identifier: BSD-3-Clause
#include "OptionValues.h"

#include "Messages.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace widefov
{
namespace
{
// Strict: the whole text is one finite number, with a point whatever the locale.
bool Read(const std::string& text, double& value)
{
  const char* begin = text.data();
  const char* const end = begin + text.size();
  if (begin != end && *begin == '+')
  {
    ++begin;
  }
  const auto [stop, error] = std::from_chars(begin, end, value);
  return error == std::errc() && stop == end && std::isfinite(value);
}
}

bool Range::Contains(double value) const
{
  return value <= this->High && (this->Open ? value > this->Low : value >= this->Low);
}

std::string Range::Describe() const
{
  return (this->Open ? "in (" : "in [") + Text(this->Low) + ", " + Text(this->High) + "]";
}

double ParseNumber(const std::string& option, const std::string& text, const Range& range)
{
  double value = 0;
  if (!Read(text, value) || !range.Contains(value))
  {
    const bool any = std::isinf(range.Low) && std::isinf(range.High);
    FailUsage(option + ": '" + text +
      (any ? "' is not a finite number" : "' is not a number " + range.Describe()));
  }
  return value;
}

int ParseInteger(const std::string& option, const std::string& text, int low, int high)
{
  int value = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || stop != end || value < low || value > high)
  {
    FailUsage(option + ": '" + text + "' is not a whole number in [" + std::to_string(low) + ", " +
      std::to_string(high) + "]");
  }
  return value;
}

std::vector<double> ParseNumbers(
  const std::string& option, const std::string& text, std::size_t least, std::size_t most)
{
  std::vector<double> values;
  bool good = true;
  for (std::size_t begin = 0; good && begin <= text.size();)
  {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    double value = 0;
    good = Read(text.substr(begin, end - begin), value);
    values.push_back(value);
    begin = end + 1;
  }
  if (!good || values.size() < least || values.size() > most)
  {
    const std::string count =
      least == most ? std::to_string(least) : std::to_string(least) + " to " + std::to_string(most);
    FailUsage(option + ": '" + text + "' is not " + count +
      " finite numbers with commas between them and no blanks");
  }
  return values;
}

std::string Choose(const std::string& option, const std::string& text,
  const std::vector<std::string>& choices, const std::vector<Alias>& aliases)
{
  const std::string chosen = MatchName(text, choices, aliases);
  if (chosen.empty())
  {
    FailUsage(option + ": there is no '" + text + "'" +
      DidYouMean(NearestName(text, choices, aliases)) + "; choose one of " + Join(choices));
  }
  return chosen;
}

std::string Join(const std::vector<std::string>& names, const std::string& separator)
{
  std::string text;
  for (const std::string& name : names)
  {
    text += (text.empty() ? "" : separator) + name;
  }
  return text;
}
}
