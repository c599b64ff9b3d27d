// SPDX-License-Identifier: BSD-3-Clause
// Names of numbered files: frames/%05d.png.
#ifndef WideFoVNumberPattern_h
#define WideFoVNumberPattern_h

#include <optional>
#include <string>

namespace widefov
{
class NumberPattern
{
public:
  // Nothing where the file's name (not its folder's) has no place for one number: %d, %5d, %05d.
  static std::optional<NumberPattern> Parse(const std::string& path);

  // The path of that number.
  std::string Name(long long number) const;

  // The number in a path of this pattern.
  std::optional<long long> NumberIn(const std::string& path) const;

private:
  std::string Before;
  std::string After;
  std::size_t Digits = 0; // at least so many
};
}

#endif
