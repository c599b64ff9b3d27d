// SPDX-License-Identifier: BSD-3-Clause
#include "TimeLine.h"

#include <algorithm>
#include <utility>

namespace widefov
{
namespace
{
// Kibibytes: what of the steps stays in memory. Those first read stay, for who goes round and round
// would throw out each one just before it is needed.
constexpr std::size_t MostMemory = 1 << 20;

std::size_t SizeOf(const Scene& scene)
{
  std::size_t size = 0;
  for (const SceneProp& prop : scene.Props)
  {
    size += prop.Surface->GetActualMemorySize() + prop.Source->GetActualMemorySize();
  }
  for (const SceneVolume& volume : scene.Volumes)
  {
    size += volume.Data->GetActualMemorySize();
  }
  return size;
}
}

TimeLine::TimeLine(std::shared_ptr<FilmScenes> scenes, double rate)
  : Scenes(std::move(scenes))
  , Rate(rate)
  , Step(Scenes->GetFirstStep())
{
}

void TimeLine::Play(bool on, Clock::time_point now)
{
  this->Plays = on;
  this->Since = now;
}

std::optional<double> TimeLine::GetPause(Clock::time_point now) const
{
  if (!this->Plays)
  {
    return std::nullopt;
  }
  const double whole = static_cast<double>(this->GetCount()) / this->Rate;
  const std::chrono::duration<double> shown = now - this->Since;
  return std::max(0., whole * this->GetSeries().ShareOf(this->Step) - shown.count());
}

std::size_t TimeLine::After(long long steps) const
{
  const auto count = static_cast<long long>(this->GetCount());
  const long long step = (static_cast<long long>(this->Step) + steps) % count;
  return static_cast<std::size_t>(step < 0 ? step + count : step);
}

Scene TimeLine::Read(std::size_t step)
{
  if (const auto kept = this->Kept.find(step); kept != this->Kept.end())
  {
    return kept->second;
  }
  const Scene& scene = this->Scenes->GetScene(step);
  const std::size_t size = SizeOf(scene);
  if (this->KeptSize + size <= MostMemory)
  {
    this->Kept[step] = scene;
    this->KeptSize += size;
  }
  return scene;
}

void TimeLine::Show(std::size_t step, Clock::time_point now)
{
  this->Step = step;
  this->Since = now;
}
}
