// SPDX-License-Identifier: BSD-3-Clause
// Data that change with time: which step is shown, and when the next one is due.
#ifndef WideFoVTimeLine_h
#define WideFoVTimeLine_h

#include "Pictures/FilmScenes.h"
#include "Scenes/Scene.h"

#include <chrono>
#include <cstddef>
#include <map>
#include <memory>
#include <optional>

namespace widefov
{
// Plays round and round. The clock waits for the drawing, so that each step is seen.
class TimeLine
{
public:
  using Clock = std::chrono::steady_clock;

  // rate: steps a second, on average.
  TimeLine(std::shared_ptr<FilmScenes> scenes, double rate);

  const DataSeries& GetSeries() const { return *this->Scenes->GetSeries(); }
  std::size_t GetCount() const { return this->GetSeries().GetSteps().size(); }
  std::size_t GetStep() const { return this->Step; }
  double GetTime() const { return this->GetSeries().GetSteps()[this->Step].Time; }

  bool IsPlaying() const { return this->Plays; }
  void Play(bool on, Clock::time_point now);

  // Seconds until the next step is due, 0 where it is; nothing while it does not play.
  std::optional<double> GetPause(Clock::time_point now) const;

  // So many steps on, round and round.
  std::size_t After(long long steps) const;

  // True where a step need not be read any more.
  bool IsKept(std::size_t step) const { return this->Kept.count(step) > 0; }

  // Reads it where it is not kept, and does not show it yet. Throws a Failure with ExitFailed where
  // no step can be read.
  Scene Read(std::size_t step);

  // From now on that step is shown.
  void Show(std::size_t step, Clock::time_point now);

private:
  std::shared_ptr<FilmScenes> Scenes;
  double Rate;
  std::size_t Step;
  bool Plays = false;
  Clock::time_point Since; // the step is shown
  std::map<std::size_t, Scene> Kept;
  std::size_t KeptSize = 0; // kibibytes
};
}

#endif
