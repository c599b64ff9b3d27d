// SPDX-License-Identifier: BSD-3-Clause
#include "Spread.h"

#include <algorithm>

namespace widefov
{
Spread SpreadOf(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  const double median =
    values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
  return { median, values.front(), values.back() };
}
}
