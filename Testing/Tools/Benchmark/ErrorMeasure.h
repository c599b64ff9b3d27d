// SPDX-License-Identifier: BSD-3-Clause
// How far runs are from the ray caster's picture.
#ifndef WideFoVErrorMeasure_h
#define WideFoVErrorMeasure_h

#include "BenchStage.h"
#include "RayCaster.h"

#include <map>
#include <memory>
#include <string>

namespace wfv
{
namespace bench
{
// Keeps one ray caster and one picture of it a view, which the runs share.
class ErrorMeasure
{
public:
  explicit ErrorMeasure(BenchStage& stage)
    : Stage(stage)
  {
  }

  // None for the floor, which shows another view.
  std::optional<ErrorFigures> Measure(BenchEntry& entry);

  // Pixels of that view in which the ray caster hits something.
  long CountHits(BenchEntry& entry);

private:
  struct Truth
  {
    std::unique_ptr<reference::RayCaster> Caster;
    reference::HitPicture Picture;
  };
  Truth& TruthOf(BenchEntry& entry);

  BenchStage& Stage;
  std::map<std::string, Truth> Truths; // by projection and fields of view
};
}
}

#endif
