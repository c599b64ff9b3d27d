// SPDX-License-Identifier: BSD-3-Clause
#include "StereoChoice.h"

#include "StereoLayout.h"

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

std::array<int, 2> SizeOfFile(const Options& o)
{
  std::array<int, 2> size = o.Size;
  if (HasTwoEyes(o))
  {
    const StereoLayout& layout = FindStereoLayout(o.Layout);
    const auto times = [&layout](int pixels, int eyes) {
      return eyes * (layout.Half && eyes == 2 ? (pixels + 1) / 2 : pixels);
    };
    size = { { times(size[0], layout.Columns), times(size[1], layout.Rows) } };
  }
  return size;
}
}
