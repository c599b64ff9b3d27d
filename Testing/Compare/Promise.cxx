// SPDX-License-Identifier: BSD-3-Clause
#include "Promise.h"

#include "HiddenFaces.h"
#include "RayCaster.h"

#include <gtest/gtest.h>

#include <iostream>

namespace wfv
{
namespace test
{
void ExpectFacesThatAreThere(const reference::RayCaster& caster, const Shot& shot,
  const reference::Metrics& m, double tolerance, const std::string& scene)
{
  for (const reference::WorstPixel& pixel : m.Worst)
  {
    EXPECT_TRUE(reference::MayShow(caster, shot.Width, shot.Height, pixel, tolerance))
      << scene << "\n  " << Describe(shot) << "\n    "
      << DescribePixel(caster.GetView(), shot.Width, shot.Height, pixel);
  }
}

long MostOff(double share, long pixels)
{
  const double mean = share * double(pixels);
  return static_cast<long>(mean + MostDeviations * std::sqrt(mean));
}

void ExpectPromise(const reference::RayCaster& caster, const Shot& shot,
  const reference::Metrics& m, double tolerance, const std::string& scene, double share)
{
  const std::string details =
    scene + "\n  " + Describe(shot) + "\n" + Details(shot, caster.GetView(), m);
  const long off = reference::CountOff(caster, shot.Width, shot.Height, m, tolerance);
  ASSERT_LT(off, long(reference::Metrics::MaxWorst)) << details; // or not all are known
  EXPECT_LE(off, MostOff(share, long(shot.Width) * shot.Height)) << details;
  ExpectFacesThatAreThere(caster, shot, m, tolerance, scene);
}

void ExpectPromise(const Drawing& drawing, const Shot& shot, const reference::DrawnPicture& picture,
  double tolerance, const std::string& scene)
{
  ASSERT_EQ(picture.Width, shot.Width) << "nothing was drawn: " << Describe(shot);
  const reference::RayCaster caster(drawing.GetMesh(), drawing.GetView(), drawing.GetPose());
  const reference::Metrics m = reference::Compare(picture, caster, tolerance);
  std::cout << Row(shot, scene, m) << std::endl;
  ExpectPromise(caster, shot, m, tolerance, scene);
}
}
}
