// SPDX-License-Identifier: BSD-3-Clause
// Where a head is, as trackers tell it.
#ifndef WideFoVHeadPose_h
#define WideFoVHeadPose_h

#include "Scenes/Look.h"
#include "Stereo/Screen.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace widefov
{
// Room coordinates, the unit of the room: x right, y up, z behind.
struct HeadPose
{
  double Time = 0;          // seconds, from any beginning
  bool HasPosition = false; // six degrees of freedom; else three, the turn alone
  wfv::Head Head;
};

// What a tracker is to a program that draws.
class HeadObserver
{
public:
  virtual ~HeadObserver() = default;

  // The pose to draw with next; nothing when there will be no other.
  virtual std::optional<HeadPose> Next() = 0;
};

// Poses from a file, in their order. A line is a pose: time x y z qx qy qz qw (six degrees of
// freedom) or time qx qy qz qw (three), blanks between; lines that begin with # are comments.
// Time is not waited for (PlayedHead in Examples/Viewer does). Of eight numbers this is the
// trajectory format of the TUM RGB-D benchmark.
class RecordedHead : public HeadObserver
{
public:
  // Throws a Failure with ExitFailed that names the line: no file, no pose, no numbers, some
  // that are not finite, a quaternion of length 0, three and six degrees of freedom mixed.
  explicit RecordedHead(const std::string& path);

  std::optional<HeadPose> Next() override;

private:
  std::vector<HeadPose> Poses;
  std::size_t Taken = 0;
};
}

#endif
