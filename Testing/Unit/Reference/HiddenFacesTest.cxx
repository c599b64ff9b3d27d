// SPDX-License-Identifier: BSD-3-Clause
// What the technique `auto` may show that is seen nowhere near, against pictures of a few
// triangles.
#include "HiddenFaces.h"
#include "PlacedTriangles.h"

#include <gtest/gtest.h>

using namespace wfv;
using namespace wfv::reference;
using namespace wfv::test;

namespace
{
const vec2 Centre(600.5, 256.5); // of pixel (600, 256), next to the equator
constexpr double Tolerance = 0.25;

// Left of the pixel and right of it, above and below, so many pixels from its centre.
vec2 At(double right, double down)
{
  return Centre + vec2(right, down);
}

class Picture : public PlacedTriangles
{
public:
  // A triangle round the pixel, a cell of its own.
  void AddWall(double distance)
  {
    this->Add(distance, { { At(-60, 40), At(60, 40), At(0, -70) } });
  }

  // A triangle on the left, whose right side runs down so many pixels beside the pixel's centre.
  void AddLeftOf(double distance, double side)
  {
    this->Add(distance, { { At(side, -50), At(side, 50), At(-60, 0) } });
  }

  void AddRightOf(double distance, double side)
  {
    this->Add(distance, { { At(side, -50), At(side, 50), At(60, 0) } });
  }

  // Of a picture that shows this cell at the pixel.
  WorstPixel Drawing(vtkIdType cell) const
  {
    const RayCaster caster(this->Soup, WholeSphere());
    const Hit hit = caster.Cast(PixelToNdc(Centre.x, Centre.y, PlacedWidth, PlacedHeight));
    WorstPixel pixel;
    pixel.I = int(Centre.x);
    pixel.J = int(Centre.y);
    pixel.Drawn = cell;
    pixel.Reference = hit.Cell;
    pixel.ReferenceDistance = hit.Distance;
    return pixel;
  }

  bool IsThere(vtkIdType cell) const
  {
    const RayCaster caster(this->Soup, WholeSphere());
    return reference::IsThere(caster, PlacedWidth, PlacedHeight, this->Drawing(cell), Tolerance);
  }

  bool IsSeen(vtkIdType cell) const
  {
    const RayCaster caster(this->Soup, WholeSphere());
    return IsSeenWithin(caster, PlacedWidth, PlacedHeight, this->Drawing(cell), Tolerance);
  }

  bool IsBesideRim() const
  {
    const RayCaster caster(this->Soup, WholeSphere());
    return reference::IsBesideRim(caster, PlacedWidth, PlacedHeight, this->Drawing(0), Tolerance);
  }

  bool IsHardlyHidden(vtkIdType cell) const
  {
    const RayCaster caster(this->Soup, WholeSphere());
    return reference::IsHardlyHidden(caster, PlacedWidth, PlacedHeight, this->Drawing(cell));
  }
};
}

TEST(HiddenFaces, AreThereWhereTheyRunThroughTheRay)
{
  Picture picture;
  picture.AddWall(10);
  picture.AddWall(5);
  picture.AddLeftOf(20, -0.3);
  picture.AddLeftOf(20, -0.2);
  EXPECT_TRUE(picture.IsThere(0));
  EXPECT_FALSE(picture.IsSeen(0));
  EXPECT_TRUE(picture.IsSeen(1));
  EXPECT_FALSE(picture.IsThere(2)) << "farther than the tolerance";
  EXPECT_TRUE(picture.IsThere(3));
  EXPECT_FALSE(picture.IsThere(-1)) << "a hole";
}

TEST(HiddenFaces, ShowBesideABorder)
{
  for (const double side : { 0.1, 0.2, 0.3, 5.0 })
  {
    Picture picture;
    picture.AddWall(10);
    picture.AddLeftOf(5, side);
    EXPECT_EQ(picture.IsBesideRim(), side < Tolerance) << side;
  }
}

TEST(HiddenFaces, DoNotShowWhereASurfaceGoesOn)
{
  Picture picture;
  picture.AddWall(10);
  picture.AddLeftOf(5, 0.1);
  picture.AddRightOf(5, 0.1);
  EXPECT_FALSE(picture.IsBesideRim()) << "a crack between the two";
}

TEST(HiddenFaces, ShowBesideASilhouette)
{
  Picture picture;
  picture.AddWall(10);
  // a roof that turns away: both are left of the ridge
  picture.AddLeftOf(5, 0.1);
  picture.Add({ { 5, 5, 7 } }, { { At(0.1, -50), At(0.1, 50), At(-40, 0) } });
  EXPECT_TRUE(picture.IsBesideRim());
}

TEST(HiddenFaces, DoNotShowBesideWhatIsHiddenItself)
{
  Picture picture;
  picture.AddWall(10);
  picture.AddLeftOf(20, 0.1);
  EXPECT_FALSE(picture.IsBesideRim());
}

TEST(HiddenFaces, ShowWhereDepthAlongAChordDoesNotTell)
{
  Picture picture;
  picture.AddWall(10);
  picture.AddWall(10 * (1 + 0.9 * ChordDepth));
  picture.AddWall(10 * (1 + 1.1 * ChordDepth));
  picture.AddLeftOf(10, -0.1);
  EXPECT_TRUE(picture.IsHardlyHidden(1));
  EXPECT_FALSE(picture.IsHardlyHidden(2));
  EXPECT_TRUE(picture.IsHardlyHidden(3)) << "not on the ray, but drawn no farther away";
}

TEST(HiddenFaces, AreCountedWhereTheyAreNotSeenNear)
{
  Picture picture;
  picture.AddWall(10);
  picture.AddWall(5);
  const RayCaster caster(picture.Soup, WholeSphere());
  Metrics m;
  m.Worst = { picture.Drawing(0), picture.Drawing(1), picture.Drawing(0) };
  EXPECT_EQ(CountOff(caster, PlacedWidth, PlacedHeight, m, Tolerance), 2);
}
