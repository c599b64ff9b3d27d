// SPDX-License-Identifier: BSD-3-Clause
// The ratios that a benchmark is asked for.
#ifndef WideFoVSummary_h
#define WideFoVSummary_h

#include "Record.h"

#include <vector>

namespace wfv
{
namespace bench
{
// Each under a name that says which, with the scene behind it:
//   "time auto_0.25 / floor, room": 1.4
// and where the camera moves before each frame, with several samples or with one:
//   "time auto_0.25 / cubemap_326 while turning, room": 1.1
//   "time auto_0.25 / cubemap-ss_652 in a film with 4 samples, room": 0.6
//   "time auto_0.25 / vertex of first frames, room": 1.9
// A ratio whose records are missing is left out. "time of the cubemap at the error of X / X"
// is null where no resolution that was measured reaches the error.
Json Summarize(const std::vector<Record>& records);

// Those of the paper's table: what a projection, a field of view and multisampling cost beside the
// perspective.
Json SummarizeTable1(const std::vector<Record>& records);
}
}

#endif
