// SPDX-License-Identifier: BSD-3-Clause
// Values on the command line: strict, and finite.
#ifndef WideFoVOptionValues_h
#define WideFoVOptionValues_h

#include "NameMatch.h"

#include <string>
#include <vector>

namespace widefov
{
// A closed range of numbers; Open excludes the lower end.
struct Range
{
  double Low;
  double High;
  bool Open = false;

  bool Contains(double value) const;
  std::string Describe() const; // "in [0, 1]"
};

// Each throws a Failure with ExitUsage whose text names the option and what it takes.
double ParseNumber(const std::string& option, const std::string& text, const Range& range);
int ParseInteger(const std::string& option, const std::string& text, int low, int high);

// Numbers separated by commas, at least `least` and at most `most` of them.
std::vector<double> ParseNumbers(
  const std::string& option, const std::string& text, std::size_t least, std::size_t most);

// The one of the choices that the text means (NameMatch.h).
std::string Choose(const std::string& option, const std::string& text,
  const std::vector<std::string>& choices, const std::vector<Alias>& aliases = {});

// "a, b, c"
std::string Join(const std::vector<std::string>& names, const std::string& separator = ", ");
}

#endif
