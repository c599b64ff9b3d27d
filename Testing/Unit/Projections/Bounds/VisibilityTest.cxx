// SPDX-License-Identifier: BSD-3-Clause
// Boxes that a view is said not to show: no point of them is in the picture.
#include "Views.h"
#include "Projections/Bounds/Visibility.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

using namespace wfv;
using namespace wfv::test;

namespace
{
constexpr int Boxes = 400; // a view
constexpr int Points = 60; // a box

class Random
{
public:
  double Unit() { return this->Distribution(this->Engine); }
  vec3 Vector() { return vec3(this->Unit(), this->Unit(), this->Unit()); }

  // Sizes and distances over four decades, some round the eye or touching planes of the axes.
  Box MakeBox()
  {
    const vec3 middle = this->Vector() * std::pow(10, 2 * this->Unit());
    const vec3 half = glm::abs(this->Vector()) * std::pow(10, 2 * this->Unit() - 1);
    Box box;
    box.Add(middle - half);
    box.Add(middle + half);
    const int axis = std::min(2, int(1.5 * (this->Unit() + 1)));
    if (this->Unit() > 0.5)
    {
      box.Low[axis] = std::min(0.0, box.High[axis]);
    }
    return box;
  }

  vec3 PointOf(const Box& box)
  {
    vec3 p;
    for (int i = 0; i < 3; ++i)
    {
      const double t = std::clamp(0.75 * this->Unit() + 0.5, 0.0, 1.0); // borders often
      p[i] = box.Low[i] + t * (box.High[i] - box.Low[i]);
    }
    return p;
  }

private:
  std::mt19937_64 Engine{ 13 };
  std::uniform_real_distribution<double> Distribution{ -1, 1 };
};

std::vector<NamedView> WideViews()
{
  std::vector<NamedView> views;
  for (NamedView& v : AllViews())
  {
    if (v.TheView.GetProjection().Axis != Family::Planar)
    {
      ViewOptions o = v.Options;
      o.Radii = { { 0.05, 20 } };
      views.push_back(MakeView(v.TheView.GetProjection(), o));
    }
  }
  return views;
}
}

TEST(Visibility, DropsNothingThatIsSeen)
{
  Random random;
  long unseen = 0;
  for (const NamedView& named : WideViews())
  {
    const View& view = named.TheView;
    const WfvView& v = view.GetParameters();
    for (int i = 0; i < Boxes; ++i)
    {
      const Box box = random.MakeBox();
      if (!IsCulled(view.GetProjection(), v, box, Window()))
      {
        continue;
      }
      ++unseen;
      for (int k = 0; k < Points; ++k)
      {
        const vec3 p = random.PointOf(box);
        ASSERT_FALSE(view.Forward(wfvUntilt(p, v)).Inside)
          << named.Name << ", " << Text(p) << " of " << Text(box.Low) << " " << Text(box.High);
      }
    }
  }
  EXPECT_GT(unseen, 1000);
}

// What lies well beside the window is found to do so.
TEST(Visibility, DropsWhatIsBeside)
{
  Random random;
  for (const NamedView& named : WideViews())
  {
    const Projection& p = named.TheView.GetProjection();
    const double fov = named.Options.HorizontalFov;
    if (fov > 120 || p.Axis == Family::Faces || p.Axis == Family::Sampled)
    {
      continue;
    }
    for (int i = 0; i < 50; ++i)
    {
      // in the half behind the eye
      vec3 d = glm::normalize(random.Vector());
      d.z = std::abs(d.z) + 0.2;
      d.y *= p.Axis == Family::Meridian ? 0.5 : 1;
      Box box;
      box.Add(d * 3.0 - 0.1);
      box.Add(d * 3.0 + 0.1);
      EXPECT_TRUE(IsCulled(p, named.TheView.GetParameters(), box, Window()))
        << named.Name << ", " << Text(d);
    }
  }
}

// Where a window is said to show all directions the clip spheres alone leave boxes out.
TEST(Visibility, KnowsWindowsThatShowAll)
{
  Random random;
  Window window; // with a margin, as stages have it
  window.Low -= 1e-3;
  window.High += 1e-3;
  int all = 0;
  for (const NamedView& named : WideViews())
  {
    const Projection& p = named.TheView.GetProjection();
    const WfvView& v = named.TheView.GetParameters();
    const bool shows = ShowsAll(p, v, window);
    bool agrees = true;
    for (int i = 0; i < Boxes; ++i)
    {
      const Box box = random.MakeBox();
      agrees = agrees && IsCulled(p, v, box, window) == !IsBetweenClips(v, box);
    }
    EXPECT_TRUE(agrees || !shows) << named.Name;
    const bool turns = p.Axis == Family::Meridian || p.Axis == Family::Azimuthal;
    all += shows && turns;
    Window half = window;
    half.High.x = 0;
    EXPECT_FALSE(turns && ShowsAll(p, v, half)) << named.Name;
  }
  EXPECT_GT(all, 8); // maps of the whole sphere
}

TEST(Visibility, KnowsTheClipSpheres)
{
  ViewOptions o;
  o.Radii = { { 1, 10 } };
  const View view(*FindProjection("equirectangular"), o);
  const auto unseen = [&](const vec3& low, const vec3& high) {
    Box box;
    box.Add(low);
    box.Add(high);
    return IsCulled(view.GetProjection(), view.GetParameters(), box, Window());
  };
  EXPECT_TRUE(unseen(vec3(-0.5), vec3(0.5)));
  EXPECT_FALSE(unseen(vec3(-0.6), vec3(0.6))); // its corners are outside the near sphere
  EXPECT_TRUE(unseen(vec3(10.1, -1, -1), vec3(11, 1, 1)));
  EXPECT_FALSE(unseen(vec3(9.9, -1, -1), vec3(11, 1, 1)));
}

// A point beside the rim whose square reaches inside, and one that stands across the seam from the
// part of the picture that it reaches over to.
TEST(Visibility, ReckonsWithWhatIsWide)
{
  const auto at = [](double longitude) {
    Box box;
    const double a = longitude * WFV_PI / 180;
    box.Add(3.0 * vec3(std::sin(a), 0, -std::cos(a)));
    return box;
  };
  ViewOptions o;
  o.Radii = { { 0.1, 10 } };
  Window wide;
  wide.Footprint = vec2(0.03);
  o.HorizontalFov = o.VerticalFov = 170;
  const View round(*FindProjection("azimuthal-equidistant"), o);
  const auto unseen = [](const View& view, const Box& box, const Window& window) {
    return IsCulled(view.GetProjection(), view.GetParameters(), box, window);
  };
  EXPECT_TRUE(unseen(round, at(86), Window()));
  EXPECT_FALSE(unseen(round, at(86), wide));
  EXPECT_TRUE(unseen(round, at(100), wide));
  o.HorizontalFov = 360;
  o.VerticalFov = 180;
  for (const char* const name : { "equirectangular", "hammer" })
  {
    const View all(*FindProjection(name), o);
    Window left = wide;
    left.High.x = -0.5;
    EXPECT_FALSE(unseen(all, at(179), left)) << name;
    EXPECT_TRUE(unseen(all, at(80), left)) << name;
    left.Footprint = vec2(0);
    EXPECT_TRUE(unseen(all, at(179), left)) << name;
  }
}
