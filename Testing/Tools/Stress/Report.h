// SPDX-License-Identifier: BSD-3-Clause
// Everything a stress run found, as its JSON.
#ifndef WideFoVStressReport_h
#define WideFoVStressReport_h

#include "Counts.h"
#include "StressOptions.h"

#include <map>

namespace wfv
{
namespace stress
{
class Report
{
public:
  explicit Report(const StressOptions& options)
    : Options(options)
  {
  }

  // The result of a batch, as Supervise gives it.
  void Add(const BatchId& id, const Json& result);

  Json ToJson() const;

private:
  using Key = std::pair<std::string, std::string>; // case or projection, technique
  void AddFailure(const BatchId& id, const std::string& technique, const Json& result);

  StressOptions Options;
  Counts Total;
  std::map<std::string, long> Primitives; // of each projection
  std::map<Key, Counts> ByCase;
  std::map<Key, Counts> ByProjection;
  std::map<std::string, int> FailuresOf; // of each projection, case and technique
  Json Failures = Json::array();
};
}
}

#endif
