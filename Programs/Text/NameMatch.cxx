// SPDX-License-Identifier: BSD-3-Clause
#include "NameMatch.h"

#include <algorithm>
#include <cctype>

namespace widefov
{
namespace
{
// Letters of the beginning of a name that stand for it.
constexpr std::size_t LeastBeginning = 3;

// How many slips a name of this length may have and still be meant.
std::size_t MostSlips(std::size_t length)
{
  return length < 4 ? 1 : length < 8 ? 2 : 3;
}

std::string Plain(const std::string& text)
{
  std::string plain;
  for (const char c : text)
  {
    const bool between = c == ' ' || c == '_';
    plain += between ? '-' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  return plain;
}

// Letters that are left out, added, wrong or swapped with the next one: the optimal string
// alignment distance.
std::size_t CountSlips(const std::string& a, const std::string& b)
{
  std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); i++)
  {
    for (std::size_t j = 0; j <= b.size(); j++)
    {
      if (i == 0 || j == 0)
      {
        d[i][j] = i + j;
        continue;
      }
      const std::size_t wrong = a[i - 1] == b[j - 1] ? 0 : 1;
      d[i][j] = std::min({ d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + wrong });
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
      {
        d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
      }
    }
  }
  return d[a.size()][b.size()];
}
}

std::string MatchName(
  const std::string& text, const std::vector<std::string>& names, const std::vector<Alias>& aliases)
{
  const std::string plain = Plain(text);
  for (const std::string& name : names)
  {
    if (Plain(name) == plain)
    {
      return name;
    }
  }
  for (const auto& [alias, name] : aliases)
  {
    // an alias of a name that is not to be chosen here says nothing
    if (Plain(alias) == plain && std::find(names.begin(), names.end(), name) != names.end())
    {
      return name;
    }
  }
  return "";
}

std::string NearestName(
  const std::string& text, const std::vector<std::string>& names, const std::vector<Alias>& aliases)
{
  std::vector<std::string> all = names;
  for (const auto& [alias, name] : aliases)
  {
    all.push_back(alias);
  }
  const std::string plain = Plain(text);
  for (const std::string& name : all)
  {
    if (plain.size() >= LeastBeginning && Plain(name).compare(0, plain.size(), plain) == 0)
    {
      return name;
    }
  }
  std::string nearest;
  std::size_t least = MostSlips(plain.size()) + 1;
  for (const std::string& name : all)
  {
    const std::size_t slips = CountSlips(plain, Plain(name));
    if (slips < least && slips < name.size())
    {
      least = slips;
      nearest = name;
    }
  }
  return nearest;
}

std::string DidYouMean(const std::string& nearest)
{
  return nearest.empty() ? "" : ", did you mean " + nearest;
}
}
