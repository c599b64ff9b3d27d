// SPDX-License-Identifier: BSD-3-Clause
// Numbers in messages, in their own digits: 360, 170.102258.
#ifndef NumberText_h
#define NumberText_h

#include <cmath>
#include <cstdio>
#include <string>

namespace wfv
{
// At most six decimals, none of them a last zero; of huge ones the power of ten.
inline std::string NumberText(double v)
{
  constexpr double huge = 1e15;
  if (std::abs(v) >= huge)
  {
    char text[32];
    std::snprintf(text, sizeof(text), "%g", v);
    return text;
  }
  std::string s = std::to_string(v);
  s.erase(s.find_last_not_of('0') + 1);
  return s.back() == '.' ? s.substr(0, s.size() - 1) : s;
}
}

#endif
