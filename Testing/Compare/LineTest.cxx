// SPDX-License-Identifier: BSD-3-Clause
// Lines of the techniques exact and auto against the reference in double (LineCheck.h).
#include "DrawingTest.h"
#include "LineCheck.h"
#include "SampledShot.h"
#include "Stereo/Stereo.h"

using namespace wfv;
using namespace wfv::test;

class CompareLines : public DrawingTest
{
};

TEST_P(CompareLines, Nasty)
{
  for (const LineScene& scene : NastyLines())
  {
    for (double width : { 1.0, 3.0, 20.0 })
    {
      CheckLines(*Picture, LineShot(this->GetParam(), 1024), scene, width);
    }
  }
}

TEST_P(CompareLines, Random)
{
  for (unsigned int seed = 1; seed <= 12; seed++)
  {
    const double width = seed % 3 == 0 ? 1 : (seed % 3 == 1 ? 4 : 13);
    CheckLines(*Picture, LineShot(this->GetParam(), 1024), RandomLines(seed, 12, 1), width);
  }
}

// Thin ones as chords.
class CompareChords : public DrawingTest
{
};

TEST_P(CompareChords, Nasty)
{
  for (const LineScene& scene : NastyLines())
  {
    CheckLines(*Picture, LineShot(this->GetParam(), 1024), scene, 1, ChordRules(1));
  }
}

TEST_P(CompareChords, Random)
{
  for (unsigned int seed = 1; seed <= 12; seed++)
  {
    const Shot shot = LineShot(this->GetParam(), 1024);
    CheckLines(*Picture, shot, RandomLines(seed, 12, 1), 1, ChordRules(1));
  }
}

// Both eyes, whose rays begin on a circle.
TEST_P(CompareChords, Eyes)
{
  Shot shot = LineShot(this->GetParam(), 512);
  shot.Options.Stereo.Model = FindStereoModel("omnidirectional");
  shot.Options.Stereo.InterpupillaryDistance = 0.11;
  for (Eye eye : { Eye::Left, Eye::Right })
  {
    shot.Options.Stereo.Eye = eye;
    for (unsigned int seed = 1; seed <= 6; seed++)
    {
      CheckLines(*Picture, shot, RandomLines(seed, 12, 1), 1, ChordRules(1));
    }
  }
}

// The same where the rays of an eye begin on a circle: each point of a line is where its own ray
// sees it.
class CompareStereoLines : public DrawingTest
{
protected:
  static void CheckEyes(
    const Shot& mono, double interpupillary, const LineScene& scene, double width)
  {
    Shot shot = mono;
    shot.Options.Stereo.Model = FindStereoModel("omnidirectional");
    shot.Options.Stereo.InterpupillaryDistance = interpupillary;
    for (Eye eye : { Eye::Left, Eye::Right })
    {
      shot.Options.Stereo.Eye = eye;
      CheckLines(*Picture, shot, scene, width);
      ASSERT_EQ(Picture->GetView().GetStereoModel(), shot.Options.Stereo.Model) << Describe(shot);
    }
  }
};

TEST_P(CompareStereoLines, Nasty)
{
  for (const LineScene& scene : NastyLines())
  {
    for (double width : { 1.0, 10.0 })
    {
      CheckEyes(LineShot(this->GetParam(), 512), 0.11, scene, width);
    }
  }
  // here what passes on either side of the eyes ends side by side
  CheckEyes(LineShot(this->GetParam(), 256), 0.11, NastyLines().front(), 10);
}

TEST_P(CompareStereoLines, Random)
{
  for (unsigned int seed = 1; seed <= 12; seed++)
  {
    const double width = seed % 3 == 0 ? 1 : (seed % 3 == 1 ? 3 : 10);
    const double interpupillary = seed % 2 == 0 ? 0.064 : 0.4;
    CheckEyes(LineShot(this->GetParam(), 512), interpupillary, RandomLines(seed, 12, 1), width);
  }
}

INSTANTIATE_TEST_SUITE_P(All, CompareLines,
  ::testing::Values("equirectangular", "hammer", "azimuthal-equidistant", "panini", "orthographic",
    "equi-angular-cubemap"),
  DrawingTest::NameOf);
INSTANTIATE_TEST_SUITE_P(All, CompareChords, ::testing::ValuesIn(WideNames()), DrawingTest::NameOf);
INSTANTIATE_TEST_SUITE_P(All, CompareStereoLines,
  ::testing::Values("equirectangular", "hammer", "azimuthal-equidistant", "panini", "orthographic",
    "equi-angular-cubemap"),
  DrawingTest::NameOf);

// The same on direction maps, made of projections: torn at their seams and poles.
class CompareSampledLines : public DrawingTest
{
protected:
  Shot SampledShot() const
  {
    Shot shot = LineShot("direction-map", 256);
    UseMapOf(this->GetParam(), shot);
    return shot;
  }
};

TEST_P(CompareSampledLines, Nasty)
{
  for (const LineScene& scene : NastyLines())
  {
    for (double width : { 1.0, 10.0 })
    {
      CheckLines(*Picture, this->SampledShot(), scene, width);
    }
  }
}

TEST_P(CompareSampledLines, Random)
{
  for (unsigned int seed = 1; seed <= 3; seed++)
  {
    const double width = seed == 3 ? 1 : (seed == 1 ? 3 : 10);
    CheckLines(*Picture, this->SampledShot(), RandomLines(seed, 12, 1), width);
  }
}

TEST_P(CompareSampledLines, Chords)
{
  for (const LineScene& scene : NastyLines())
  {
    CheckLines(*Picture, this->SampledShot(), scene, 1, ChordRules(1));
  }
  for (unsigned int seed = 1; seed <= 3; seed++)
  {
    CheckLines(*Picture, this->SampledShot(), RandomLines(seed, 12, 1), 1, ChordRules(1));
  }
}

INSTANTIATE_TEST_SUITE_P(All, CompareSampledLines,
  ::testing::Values("equirectangular", "hammer", "azimuthal-equidistant", "equi-angular-cubemap"),
  DrawingTest::NameOf);
