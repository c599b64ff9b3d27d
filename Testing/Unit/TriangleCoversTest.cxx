// SPDX-License-Identifier: BSD-3-Clause
// What is said to hold the picture of a triangle does: every place of it is in there.
#include "Stereo.h"
#include "Views.h"
#include "vtkWideFoVTrianglePieces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <random>

using namespace wfv;
using namespace wfv::test;

namespace
{
constexpr int Triangles = 3000; // a view
constexpr int OwnTriangles = 1000;
constexpr int NarrowTriangles = 700;
constexpr int TurningTriangles = 60000;
constexpr int PlacesEach = 60;
constexpr double CircleRadius = 0.2; // of the eyes' circle
const vec2 Size(1024, 512);

// Pixels: that much of what is added for float32 and rasterizers is left for what lies between the
// places that were looked at; nothing of the rest may be used up.
constexpr double CoverSlack = 0.005;

SortView MakeSortView(const View& view, const vec2& size = Size)
{
  SortView s;
  s.Map = &view.GetProjection();
  s.View = view.GetParameters();
  s.Pixels = size;
  s.Bends = std::make_shared<LocalBend>(*s.Map, s.View);
  s.Calm = true;
  s.Samples.SetPlace(0.5 * size, 0.5 * size, size);
  return s;
}

// Needles and others, of all sizes and everywhere; many beside a pole.
struct Shapes
{
  std::mt19937_64 Engine{ 11 };
  std::uniform_real_distribution<double> Unit{ -1, 1 };

  vec3 Direction()
  {
    return glm::normalize(vec3(this->Unit(Engine), this->Unit(Engine), this->Unit(Engine)));
  }

  // About a place, radians; width: of its size.
  void MakeAt(const vec3& at, double size, double width, vec3 d[3])
  {
    const vec3 along = glm::normalize(glm::cross(at, this->Direction()));
    const vec3 across = glm::cross(at, along);
    for (int i = 0; i < 3; i++)
    {
      const vec3 step = along * this->Unit(Engine) + across * (width * this->Unit(Engine));
      d[i] = glm::normalize(at + size * step);
    }
  }

  void Make(int number, vec3 d[3])
  {
    const double size = std::pow(10, -1.4 + 1.4 * this->Unit(Engine));
    const double width = number % 3 == 0 ? 1 : std::pow(10, -2 + this->Unit(Engine));
    vec3 at = this->Direction();
    if (number % 5 == 0)
    {
      at = glm::normalize(vec3(0, at.y < 0 ? -1 : 1, 0) + 0.3 * at);
    }
    this->MakeAt(at, size, width, d);
  }

  // Beside the nadir, where edges turn in a picture.
  void MakeTurning(vec3 d[3])
  {
    const double size = std::pow(10, -1.2 + 0.5 * this->Unit(Engine));
    const double width = std::pow(10, -1 + this->Unit(Engine));
    this->MakeAt(glm::normalize(vec3(0, -1, 0) + 0.3 * this->Direction()), size, width, d);
  }

  // The same at distances from the eyes' circle on, some running away from it.
  void MakeFar(int number, vec3 d[3])
  {
    this->Make(number, d);
    const double size = glm::length(d[1] - d[0]);
    const double distance = CircleRadius * std::pow(10, 1 + this->Unit(Engine));
    const double slope = number % 4 == 0 ? 1 : 0.1;
    for (int i = 0; i < 3; i++)
    {
      d[i] *= distance * (1 + slope * size * this->Unit(Engine));
    }
  }

  // In the triangle, on its edges as well.
  vec3 Inside(const vec3 d[3])
  {
    vec3 weights = glm::abs(vec3(this->Unit(Engine), this->Unit(Engine), this->Unit(Engine)));
    const int edge = static_cast<int>(8 * std::abs(this->Unit(Engine)));
    if (edge < 3)
    {
      weights[edge] = 0;
    }
    return (d[0] * weights.x + d[1] * weights.y + d[2] * weights.z) /
      (weights.x + weights.y + weights.z);
  }
};

// Pixels by which a place is outside the shape of a calm triangle: the farther of the triangle that
// its sides make, moved out, and the rectangle (preclip_narrow.glsl takes the smaller).
double OutsideCalm(const TriangleJudge::Corner c[3], unsigned int reach, const vec2& at)
{
  double sides[3];
  double grow[3];
  for (int i = 0; i < 3; i++)
  {
    sides[i] = glm::length(c[(i + 2) % 3].At - c[(i + 1) % 3].At);
    grow[i] = ((reach >> (TriangleJudge::ReachBits * i)) & 1023u) / TriangleJudge::Reaches;
  }
  const auto l = static_cast<int>(std::max_element(sides, sides + 3) - sides);
  const double others = std::max(grow[(l + 1) % 3], grow[(l + 2) % 3]);
  double outside = -1e9;
  for (int i = 0; i < 3; i++)
  {
    const vec2 from = c[(i + 1) % 3].At;
    const vec2 side = (c[(i + 2) % 3].At - from) / sides[i];
    const double height = Cross(side, c[i].At - from);
    const double beyond = Cross(side, at - from) * (height > 0 ? -1 : 1);
    outside = std::max(outside, beyond - (i == l ? grow[i] : others));
    if (i == l)
    {
      const double along = glm::dot(side, at - from);
      outside = std::max({ outside, -along - others, along - sides[i] - others,
        -beyond - std::abs(height) - others });
    }
  }
  return outside;
}

// The same of the nearest of several pieces.
double OutsidePieces(const std::vector<CoverPiece>& pieces, const vec2& middle, const vec2& at)
{
  double outside = 1e9;
  for (const CoverPiece& p : pieces)
  {
    const double length = glm::length(p.Side);
    const vec2 from = at - middle - p.From;
    const double along = glm::dot(p.Side, from) / length;
    const double up = Cross(p.Side, from) / length;
    outside = std::min(outside, std::max({ -along, along - length, -up, up - p.Height }));
  }
  return outside;
}

struct Found
{
  int Calm = 0;
  int Cut = 0;
  double WorstCalm = -1e9;
  double WorstCut = -1e9;
};

void LookAt(const SortView& view, const vec3 d[3], Shapes& shapes, Found& found)
{
  const TriangleJudge judge(view);
  const TriangleJudge::Corner c[3] = { judge.See(d[0]), judge.See(d[1]), judge.See(d[2]) };
  const TriangleJudge::Corner* const corners[3] = { &c[0], &c[1], &c[2] };
  const TriangleJudge::Verdict verdict = judge.Judge(corners);
  std::vector<CoverPiece> pieces;
  const bool cut = TrianglePieces(view).Cover(0, corners, 1e9, pieces);
  // seen by rays of their own, pieces beside the picture may be left out
  const bool all = !view.Own;
  EXPECT_TRUE(all ? cut == !pieces.empty() : cut || pieces.empty());
  found.Calm += verdict.Calm;
  found.Cut += cut;
  for (int i = 0; i < PlacesEach; i++)
  {
    const vec2 at = judge.See(shapes.Inside(d)).At;
    if (verdict.Calm)
    {
      found.WorstCalm = std::max(found.WorstCalm, OutsideCalm(c, verdict.Reach, at));
    }
    if (cut && (all || (at.x >= 0 && at.x <= view.Pixels.x)))
    {
      found.WorstCut = std::max(found.WorstCut, OutsidePieces(pieces, 0.5 * view.Pixels, at));
    }
  }
}
// Whether a view is looked at: one of a map with a formula, large enough, and not tilted, which
// changes nothing in the map's own frame.
bool Counts(const SortView& view)
{
  return view.Map->Axis != Family::Sampled && view.View.halfFov.x >= Degree &&
    view.View.tilt == vec2(1, 0);
}

// make(shapes, number, corners): one triangle; at least so many of them are to be calm.
template <typename Make>
void Check(
  const SortView& view, const std::string& name, int triangles, int leastCalm, const Make& make)
{
  const double pad = TriangleJudge::GetPad(view.Pixels);
  Shapes shapes;
  Found found;
  for (int i = 0; i < triangles; i++)
  {
    vec3 d[3];
    make(shapes, i, d);
    LookAt(view, d, shapes, found);
  }
  EXPECT_LT(found.WorstCalm, CoverSlack - pad) << name;
  EXPECT_LT(found.WorstCut, CoverSlack - pad) << name;
  std::cout << name << ": " << found.Calm << " calm, " << found.WorstCalm << "; " << found.Cut
            << " cut, " << found.WorstCut << " pixels beyond\n";
  EXPECT_GT(found.Calm, leastCalm) << name;
  EXPECT_GT(found.Cut, triangles / 100) << name;
}

void CheckAllViews(const vec2& size, int triangles)
{
  for (const NamedView& named : AllViews())
  {
    const SortView view = MakeSortView(named.TheView, size);
    if (Counts(view))
    {
      Check(view, named.Name, triangles, triangles / 10,
        [](Shapes& shapes, int number, vec3 d[3]) { shapes.Make(number, d); });
    }
  }
}
}

TEST(TriangleCovers, HoldEveryPlace)
{
  CheckAllViews(Size, Triangles);
}

// Edges of these reach beyond the ends of their chords.
TEST(TriangleCovers, HoldEveryPlaceOfNarrowPictures)
{
  CheckAllViews(vec2(2048, 64), NarrowTriangles);
  CheckAllViews(vec2(64, 2048), NarrowTriangles);
}

// Beside the nadir of a map that is stretched to the side edges turn back: what one reaches beyond
// its ends comes on top of what another bulges, for which bits may be too few.
TEST(TriangleCovers, HoldWhatTurnsBackBeyondItsEnds)
{
  for (const char* name : { "aitoff", "hammer", "winkel-tripel", "mollweide" })
  {
    const View whole(*FindProjection(name), ViewOptions());
    const SortView view = MakeSortView(whole, vec2(8192, 512));
    Shapes shapes;
    Found found;
    for (int i = 0; i < TurningTriangles; i++)
    {
      vec3 d[3];
      shapes.MakeTurning(d);
      LookAt(view, d, shapes, found);
    }
    const double pad = TriangleJudge::GetPad(view.Pixels);
    EXPECT_LT(found.WorstCalm, CoverSlack - pad) << name;
    EXPECT_LT(found.WorstCut, CoverSlack - pad) << name;
    EXPECT_GT(found.Calm, TurningTriangles / 2) << name;
    EXPECT_GT(found.Cut, TurningTriangles / 2) << name;
  }
}

// Of an eye whose rays begin on a circle, from there on, and beside its axis.
TEST(TriangleCovers, HoldEveryPlaceSeenFromACircle)
{
  for (const NamedView& named : AllViews())
  {
    ViewOptions o = named.Options;
    o.Stereo.Model = FindStereoModel("omnidirectional");
    o.Stereo.InterpupillaryDistance = 2 * CircleRadius;
    o.Stereo.Eye = Eye::Left;
    const View eye(named.TheView.GetProjection(), o);
    SortView view = MakeSortView(eye);
    view.Own = eye.GetStereoModel();
    if (view.Own && Counts(view))
    {
      Check(view, named.Name, OwnTriangles, OwnTriangles / 20,
        [](Shapes& shapes, int number, vec3 d[3]) { shapes.MakeFar(number, d); });
    }
  }
}

// Small, ahead and facing the eyes: whatever the distance, as it is without stereo. (Needles may be
// seen edge-on.)
TEST(TriangleCovers, IsEasyBesideTheCircle)
{
  ViewOptions o;
  o.Stereo.Model = FindStereoModel("omnidirectional");
  o.Stereo.InterpupillaryDistance = 2 * CircleRadius;
  o.Stereo.Eye = Eye::Left;
  const View eye(*FindProjection("equirectangular"), o);
  SortView view = MakeSortView(eye);
  view.Own = eye.GetStereoModel();
  const TriangleJudge judge(view);
  Shapes shapes;
  for (const double radii : { 1.2, 1.5, 2.0, 3.0, 10.0 })
  {
    int easy = 0;
    for (int i = 0; i < 100; i++)
    {
      const vec3 at(shapes.Unit(shapes.Engine), 0.3 * shapes.Unit(shapes.Engine), -1);
      TriangleJudge::Corner c[3];
      for (TriangleJudge::Corner& corner : c)
      {
        const vec3 d = glm::normalize(at + 0.02 * shapes.Direction());
        corner = judge.See(d * (radii * CircleRadius / std::hypot(d.x, d.z)));
      }
      const TriangleJudge::Corner* const corners[3] = { &c[0], &c[1], &c[2] };
      const TriangleJudge::Verdict verdict = judge.Judge(corners);
      easy += verdict.Calm || verdict.Empty;
    }
    EXPECT_GE(easy, 97) << radii;
  }
}
