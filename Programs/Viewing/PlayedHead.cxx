// SPDX-License-Identifier: BSD-3-Clause
#include "PlayedHead.h"

#include "Text/Messages.h"

#include <algorithm>
#include <cmath>

namespace widefov
{
PlayedHead::PlayedHead(
  const std::vector<HeadPose>& poses, double rate, bool once, const std::string& file)
  : Poses(poses)
  , Once(once)
{
  this->SetTimes(rate, file);
}

void PlayedHead::SetTimes(double rate, const std::string& file)
{
  const std::string remedy = "; correct the times, or give --pose-rate HZ";
  const std::size_t count = this->Poses.size();
  for (std::size_t i = 0; i < count; i++)
  {
    const double time = this->Poses[i].Time - this->Poses[0].Time;
    this->Begin.push_back(rate > 0 ? static_cast<double>(i) / rate : time);
    if (i > 0 && this->Begin[i] < this->Begin[i - 1])
    {
      Fail(file + ", pose " + std::to_string(i + 1) + " is earlier than the one before" + remedy);
    }
  }
  if (count == 1)
  {
    return;
  }
  const double last = this->Begin.back();
  this->End = last + last / static_cast<double>(count - 1);
  if (!(last > 0) || !std::isfinite(this->End))
  {
    Fail(file + ": from the first to the last pose there are " + Text(last) + " seconds" + remedy);
  }
}

bool PlayedHead::IsOver() const
{
  return this->Poses.size() == 1 || (this->Once && this->Time >= this->Begin.back());
}

void PlayedHead::Advance(double seconds)
{
  if (this->Poses.size() > 1)
  {
    this->Time += seconds;
    this->Time = this->Once ? std::min(this->Time, this->End) : std::fmod(this->Time, this->End);
  }
}

std::size_t PlayedHead::GetNumber() const
{
  // of several at one time the last
  const auto after = std::upper_bound(this->Begin.begin(), this->Begin.end(), this->Time);
  return static_cast<std::size_t>(after - this->Begin.begin());
}

std::optional<HeadPose> PlayedHead::Next()
{
  if (this->IsOver() && this->TookLast)
  {
    return std::nullopt;
  }
  this->TookLast = this->IsOver();
  return this->Poses[this->GetNumber() - 1];
}

std::optional<double> PlayedHead::GetPause() const
{
  if (this->IsOver())
  {
    return std::nullopt;
  }
  const std::size_t next = this->GetNumber();
  return (next < this->Begin.size() ? this->Begin[next] : this->End) - this->Time;
}
}
