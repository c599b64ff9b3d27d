// SPDX-License-Identifier: BSD-3-Clause
// Fields of view, before the projection is known.
#ifndef WideFoVFieldsOfView_h
#define WideFoVFieldsOfView_h

#include <optional>
#include <vector>

namespace widefov
{
// The fields of view as given; which ones apply depends on the projection. Degrees.
struct FieldsOfView
{
  std::optional<double> Horizontal;
  std::optional<double> Vertical;
  std::optional<double> Round;
  std::vector<double> Lens; // empty: the ideal lens
};
}

#endif
