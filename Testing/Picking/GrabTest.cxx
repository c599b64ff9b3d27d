// SPDX-License-Identifier: BSD-3-Clause
// Two hundred and twenty-eight grabs of handles of VTK's widgets, all round the eye: the one that
// is seen under the pointer moves, and no other.
#include "Grabs.h"

#include <gtest/gtest.h>

using namespace wfv;
using namespace wfv::test;

namespace
{
constexpr int GrabsOfEach = 9;
constexpr int GrabsOfBoxes = 2; // which take long to draw

void ExpectGrabs(std::string (*grab)(GrabStage&), int grabs = GrabsOfEach)
{
  const PickView views[] = { { "equirectangular" }, { "hammer" }, { "azimuthal-equidistant" },
    { "mercator" }, { "equirectangular", Eye::Middle, 70 }, { "equirectangular", Eye::Left } };
  unsigned int seed = 1;
  for (const PickView& view : views)
  {
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
  ExpectGrabs(GrabHandle);
}

TEST(Grabs, EndsOfLines)
{
  ExpectGrabs(GrabEndOfLine);
}

TEST(Grabs, Spheres)
{
  ExpectGrabs(GrabSphere);
}

TEST(Grabs, HandlesOfSpheres)
{
  ExpectGrabs(GrabHandleOfSphere);
}

TEST(Grabs, FacesOfBoxes)
{
  ExpectGrabs(GrabFaceOfBox, GrabsOfBoxes);
}
