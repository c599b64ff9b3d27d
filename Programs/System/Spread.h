// SPDX-License-Identifier: BSD-3-Clause
// What is told of repeated measurements.
#ifndef WideFoVSpread_h
#define WideFoVSpread_h

#include <vector>

namespace widefov
{
struct Spread
{
  double Median = 0;
  double Least = 0;
  double Most = 0;
};

// Of at least one value.
Spread SpreadOf(std::vector<double> values);
}

#endif
