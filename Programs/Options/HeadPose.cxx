// SPDX-License-Identifier: BSD-3-Clause
#include "HeadPose.h"

#include "System/NumberLines.h"
#include "Text/Messages.h"

#include <algorithm>
#include <cmath>

namespace widefov
{
namespace
{
// Lengths of a quaternion: beyond them it is no turn that somebody measured.
constexpr double LeastTurn = 1e-3;
constexpr double MostTurn = 1e3;

HeadPose ToPose(const std::string& where, const std::vector<double>& v)
{
  if (v.size() != 8 && v.size() != 5)
  {
    Fail(where + " has " + std::to_string(v.size()) +
      " numbers; a pose is time x y z qx qy qz qw, or time qx qy qz qw");
  }
  HeadPose pose;
  pose.Time = v[0];
  pose.HasPosition = v.size() == 8;
  if (pose.HasPosition)
  {
    pose.Head.Position = { v[1], v[2], v[3] };
  }
  const std::size_t turn = v.size() - 4;
  std::copy_n(v.begin() + static_cast<std::ptrdiff_t>(turn), 4, pose.Head.Turn.begin());
  const double length =
    std::hypot(std::hypot(v[turn], v[turn + 1]), std::hypot(v[turn + 2], v[turn + 3]));
  if (!(length > LeastTurn) || !(length < MostTurn))
  {
    Fail(where + ": a quaternion of length " + Text(length) + " is no turn; correct it");
  }
  return pose;
}
}

RecordedHead::RecordedHead(const std::string& path)
{
  for (const NumberLine& line : ReadNumberLines(path, "recorded head poses"))
  {
    this->Poses.push_back(ToPose(line.Where, line.Numbers));
    if (this->Poses.back().HasPosition != this->Poses.front().HasPosition)
    {
      Fail(line.Where + ": poses with and without a position are mixed; give one kind");
    }
  }
  if (this->Poses.empty())
  {
    Fail(path + " has no pose; a line is time x y z qx qy qz qw, or time qx qy qz qw");
  }
}

std::optional<HeadPose> RecordedHead::Next()
{
  return this->Taken < this->Poses.size() ? std::optional(this->Poses[this->Taken++])
                                          : std::nullopt;
}
}
