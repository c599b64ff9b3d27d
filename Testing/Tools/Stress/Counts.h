// SPDX-License-Identifier: BSD-3-Clause
// What a stress run counts, and its JSON.
#ifndef WideFoVStressCounts_h
#define WideFoVStressCounts_h

#include <nlohmann/json.hpp>

#include <algorithm>
#include <string>
#include <vector>

namespace wfv
{
namespace stress
{
using Json = nlohmann::ordered_json;

struct Counts
{
  long Nan = 0;         // values of colour and float channels that are not what they may be
  long GlErrors = 0;    // of OpenGL and of VTK
  long Holes = 0;       // pixels of a closed mesh hit by nothing
  long DoubleHits = 0;  // pixels of a closed mesh hit more than once
  long Unexplained = 0; // pixels that the ray caster does not explain within b
  long Crashes = 0;     // batches whose process ended or did not answer
  // beside the contract
  long Batches = 0;
  long Pixels = 0;    // compared with the ray caster
  long DepthTies = 0; // explained by two surfaces at distances that depth cannot tell apart
  long Ties = 0;      // the ray lies in an edge's plane, and a turned one sees it: RightAnswers.h
  long Thin = 0;      // of the unexplained, those that smaller circles explain
  long Near = 0;      // of the unexplained, those whose cell is seen within b all the same
  long Hidden = 0;    // of the others, those whose cell is within b, but hidden there or edge-on
  double MaxDepthRel = 0;
  double MaxPx = 0; // pixels from the farthest unexplained pixel to where its cell is seen

  void Add(const Counts& other);
  bool Failed() const;
};

Json ToJson(const Counts& counts);
Counts FromJson(const Json& json);
}
}

#endif
