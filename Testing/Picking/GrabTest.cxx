// SPDX-License-Identifier: BSD-3-Clause
// Two hundred and ten grabs of handles of VTK's widgets, all round the eye: the one that
// is seen under the pointer moves, and no other.
#include "Grabs.h"

#include <gtest/gtest.h>

using namespace wfv;
using namespace wfv::test;

namespace
{
constexpr int GrabsOfEach = 9;
constexpr int GrabsOfBoxes = 2; // which take long to draw

void ExpectGrabs(std::string (*grab)(GrabStage&), int grabs, bool inEye)
{
  const PickView views[] = { { "equirectangular" }, { "hammer" }, { "azimuthal-equidistant" },
    { "mercator" }, { "equirectangular", Eye::Middle, 70 }, { "equirectangular", Eye::Left } };
  unsigned int seed = 1;
  for (const PickView& view : views)
  {
    if (view.Which != Eye::Middle && !inEye)
    {
      continue;
    }
    GrabStage stage(view, seed++);
    for (int i = 0; i < grabs; i++)
    {
      EXPECT_EQ(grab(stage), "") << Describe(view);
    }
  }
}
}

TEST(Grabs, Handles)
{
  ExpectGrabs(GrabHandle, GrabsOfEach, false);
}

TEST(Grabs, EndsOfLines)
{
  ExpectGrabs(GrabEndOfLine, GrabsOfEach, false);
}

TEST(Grabs, Spheres)
{
  ExpectGrabs(GrabSphere, GrabsOfEach, true);
}

TEST(Grabs, HandlesOfSpheres)
{
  ExpectGrabs(GrabHandleOfSphere, GrabsOfEach, true);
}

TEST(Grabs, FacesOfBoxes)
{
  ExpectGrabs(GrabFaceOfBox, GrabsOfBoxes, true);
}
