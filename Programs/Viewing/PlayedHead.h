// SPDX-License-Identifier: BSD-3-Clause
// Recorded poses of a head, each at its time.
#ifndef WideFoVPlayedHead_h
#define WideFoVPlayedHead_h

#include "Options/HeadPose.h"

#include <optional>
#include <string>
#include <vector>

namespace widefov
{
// An observer whose next pose is the one that is due. The last one is due for as long as the
// others are on average; then the first one is again, or with `once` it stays.
class PlayedHead : public HeadObserver
{
public:
  // At least one pose. rate: poses a second; 0: as their times say. Throws a Failure with
  // ExitFailed that names the file where times that count go back, or never go on.
  PlayedHead(
    const std::vector<HeadPose>& poses, double rate, bool once, const std::string& file = "");

  // So many seconds pass.
  void Advance(double seconds);

  // Nothing after the last pose was given once.
  std::optional<HeadPose> Next() override;

  // Until another pose is due, seconds; nothing where none will be.
  std::optional<double> GetPause() const;

  // Of the pose that is due, from 1.
  std::size_t GetNumber() const;

private:
  void SetTimes(double rate, const std::string& file);
  bool IsOver() const;

  std::vector<HeadPose> Poses;
  std::vector<double> Begin; // when each is due; seconds from the first
  double End = 0;            // when the first is due again
  double Time = 0;
  bool Once;
  bool TookLast = false;
};
}

#endif
