// SPDX-License-Identifier: BSD-3-Clause
#include "StereoChoice.h"

namespace widefov
{
const wfv::StereoModel& StereoOf(const Options& o)
{
  return *wfv::FindStereoModel(o.Stereo);
}

bool HasTwoEyes(const Options& o)
{
  return StereoOf(o).Traits.TwoEyes;
}

bool ShowsCube(const Options& o)
{
  return !StereoOf(o).Traits.StraightRays;
}
}
