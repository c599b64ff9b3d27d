// SPDX-License-Identifier: BSD-3-Clause
// What refined triangles hold: chords stand for edges within the tolerance, two triangles leave no
// gap at their edge, and pieces cover a triangle once.
#include "Refine/RefineSpace.h"
#include "Refine/RefinedView.h"
#include "Views.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <map>

using namespace wfv;
using namespace wfv::test;

namespace
{
constexpr int TrianglesOfView = 100;
constexpr int PlacesOfEdge = 7; // of a chord, between its ends
constexpr int PlacesInside = 8; // a triangle
constexpr int ClustersOfView = 1500;

// Tolerances between a place of a piece and where the piece shows it: what edges that are asked may
// be off along their chords. The edges inside of a triangle are asked as well, or are shorter.
const double InsideTolerances = WFV_ALONG;

// A place that is nearer to the border of a piece, in weights, may count for both sides.
constexpr double BesideBorder = 1e-9;

double DistanceToChord(const vec2& a, const vec2& b, const vec2& p)
{
  const vec2 way = b - a;
  const double length2 = glm::dot(way, way);
  const double t = length2 > 0 ? std::clamp(glm::dot(p - a, way) / length2, 0.0, 1.0) : 0;
  return glm::length(p - a - t * way);
}

std::string Text(const Triangle& t)
{
  return wfv::test::Text(t[0]) + ", " + wfv::test::Text(t[1]) + ", " + wfv::test::Text(t[2]);
}

// The largest of a kind of error, and where it is.
struct Worst
{
  double Value = 0;
  std::string Where;

  void Take(double value, const Triangle& t)
  {
    if (!(value <= this->Value))
    {
      this->Value = value;
      this->Where = Text(t);
    }
  }
};

struct Corner
{
  vec3 Place;
  vec3 Weights;
  float Aside;
};

Corner CornerOf(const Triangle& t, const Pieces& pieces, std::size_t index)
{
  const PieceVertex& v = pieces.Vertices[pieces.Indices[index]];
  return Corner{ PlaceOf(t, v), vec3(v.Weights[0], v.Weights[1], v.Weights[2]), v.Aside };
}

bool IsOnEdge(const Corner& a, const Corner& b)
{
  return (a.Weights.x == 0 && b.Weights.x == 0) || (a.Weights.y == 0 && b.Weights.y == 0) ||
    (a.Weights.z == 0 && b.Weights.z == 0);
}

// Pixels between an edge of the mesh and the chord that is drawn for a part of it.
double ChordError(const RefinedView& v, const Corner& a, const Corner& b)
{
  double worst = 0;
  const vec2 from = v.At(a.Place, a.Aside);
  const vec2 to = v.At(b.Place, b.Aside);
  for (int i = 1; i <= PlacesOfEdge; i++)
  {
    const vec3 place = glm::mix(a.Place, b.Place, i / (PlacesOfEdge + 1.0));
    if (v.IsSeen(place) && v.PixelsFromTear(place) > v.GetTornPixels())
    {
      worst = std::max(worst, DistanceToChord(from, to, v.At(place, a.Aside)));
    }
  }
  return worst;
}

// Pixels between a place of a piece and where the piece shows it: in the picture, or, where the map
// stretches, as large as they are in its middle.
double InsideError(const RefinedView& v, const Corner c[3], const vec3& weights)
{
  const vec3 place = c[0].Place * weights.x + c[1].Place * weights.y + c[2].Place * weights.z;
  if (!v.IsSeen(place) || v.PixelsFromTear(place) <= v.GetTornPixels())
  {
    return 0;
  }
  vec2 drawn(0);
  double sum = 0;
  for (int i = 0; i < 3; i++)
  {
    const double share = weights[i] * glm::length(v.See(c[i].Place)); // gl_Position.w
    drawn += share * v.At(c[i].Place, c[i].Aside);
    sum += share;
  }
  const double pixels = glm::length(drawn / sum - v.At(place, c[0].Aside));
  return std::min(pixels, v.TurnOf(drawn / sum, place));
}

struct Errors
{
  Worst Chord;
  Worst Inside;
  long Pieces = 0;
  long Fine = 0;
};

void Measure(const RefinedView& v, const Triangle& t, Shapes& shapes, Errors& errors)
{
  const Pieces pieces = v.Refine(t);
  errors.Pieces += static_cast<long>(pieces.Numbers.size());
  errors.Fine += v.IsFine(t);
  for (std::size_t i = 0; i < pieces.Indices.size(); i += 3)
  {
    const Corner c[3] = { CornerOf(t, pieces, i), CornerOf(t, pieces, i + 1),
      CornerOf(t, pieces, i + 2) };
    for (int k = 0; k < 3; k++)
    {
      if (IsOnEdge(c[k], c[(k + 1) % 3]))
      {
        errors.Chord.Take(ChordError(v, c[k], c[(k + 1) % 3]), t);
      }
    }
    errors.Inside.Take(InsideError(v, c, shapes.Weights()), t);
  }
}

double SignedArea(const vec3& a, const vec3& b, const vec3& c)
{
  return (b.y - a.y) * (c.z - a.z) - (c.y - a.y) * (b.z - a.z);
}

// How many pieces hold a place; -1 where it is on a border of one.
int CountPieces(const Triangle& t, const Pieces& pieces, const vec3& weights)
{
  int count = 0;
  for (std::size_t i = 0; i < pieces.Indices.size(); i += 3)
  {
    double least = 1;
    vec3 w[3];
    for (int k = 0; k < 3; k++)
    {
      w[k] = CornerOf(t, pieces, i + k).Weights;
    }
    const double area = SignedArea(w[0], w[1], w[2]);
    for (int k = 0; k < 3; k++)
    {
      least = std::min(least, SignedArea(w[k], w[(k + 1) % 3], weights));
    }
    if (area > 0 && least > -BesideBorder)
    {
      if (least < BesideBorder)
      {
        return -1;
      }
      count++;
    }
  }
  return count;
}

struct Cover
{
  long Uncovered = 0; // seen places
  long Twice = 0;
  long Turned = 0;   // pieces that face the other way than their triangle
  double Pixels = 0; // of the uncovered one that is farthest from a tear
  std::string Where;
};

void MeasureCover(const RefinedView& v, const Triangle& t, Shapes& shapes, Cover& cover)
{
  const Pieces pieces = v.Refine(t);
  for (std::size_t i = 0; i < pieces.Indices.size(); i += 3)
  {
    cover.Turned += SignedArea(CornerOf(t, pieces, i).Weights, CornerOf(t, pieces, i + 1).Weights,
                      CornerOf(t, pieces, i + 2).Weights) < -1e-12;
  }
  for (int i = 0; i < PlacesInside; i++)
  {
    const vec3 weights = shapes.Weights();
    const int count = CountPieces(t, pieces, weights);
    const vec3 place = t[0] * weights.x + t[1] * weights.y + t[2] * weights.z;
    cover.Twice += count > 1;
    if (count == 0 && v.IsSeen(place) && v.PixelsFromTear(place) > v.GetTornPixels())
    {
      cover.Uncovered++;
      cover.Pixels = std::max(cover.Pixels, v.PixelsFromTear(place));
      cover.Where = Text(t) + " at " + wfv::test::Text(weights);
    }
  }
}

// The chords of one triangle along its edge from corner 0 to corner 1, each by its two ends.
using Chords = std::vector<std::pair<vec3, vec3>>;

bool IsBefore(const vec3& a, const vec3& b)
{
  return a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : a.z < b.z;
}

Chords ChordsOfEdge(const RefinedView& v, const Triangle& t, int opposite)
{
  const Pieces pieces = v.Refine(t);
  Chords chords;
  for (std::size_t i = 0; i < pieces.Indices.size(); i++)
  {
    const Corner a = CornerOf(t, pieces, i);
    const Corner b = CornerOf(t, pieces, i % 3 == 2 ? i - 2 : i + 1);
    if (a.Weights[opposite] == 0 && b.Weights[opposite] == 0)
    {
      const bool ordered = IsBefore(a.Place, b.Place);
      chords.emplace_back(ordered ? a.Place : b.Place, ordered ? b.Place : a.Place);
    }
  }
  return chords;
}

// Seen chords of one list that the other does not have, bit for bit, farther from any tear than is
// left out there.
long CountAlone(const RefinedView& v, const Chords& all, const Chords& others)
{
  return std::count_if(all.begin(), all.end(), [&](const auto& chord) {
    const vec3 middle = 0.5 * (chord.first + chord.second);
    return std::find(others.begin(), others.end(), chord) == others.end() && v.IsSeen(middle) &&
      v.PixelsFromTear(middle) > v.GetTornPixels() &&
      v.PixelsFromTear(chord.first) > v.GetTornPixels() &&
      v.PixelsFromTear(chord.second) > v.GetTornPixels();
  });
}

// calls(view): in all views of a projection.
template <typename Calls>
void InAllViews(const std::string& projection, const Calls& calls)
{
  const Projection& p = *FindProjection(projection);
  for (const auto& views : { MonoViews(p), StereoViews(p) })
  {
    for (const auto& view : views)
    {
      calls(*view);
    }
  }
}
}

class Refined : public testing::TestWithParam<std::string>
{
};

TEST_P(Refined, ChordsKeepTheTolerance)
{
  InAllViews(this->GetParam(), [](const RefinedView& v) {
    Shapes shapes(v.GetView());
    Errors errors;
    for (int i = 0; i < TrianglesOfView; i++)
    {
      Measure(v, shapes.Make(i), shapes, errors);
    }
    std::cout << v.GetName() << ": " << errors.Fine << " fine of " << TrianglesOfView << ", "
              << errors.Pieces << " pieces; chords " << errors.Chord.Value << " px, inside "
              << errors.Inside.Value << " px" << std::endl;
    EXPECT_LE(errors.Chord.Value, v.GetTolerance()) << v.GetName() << "\n  " << errors.Chord.Where;
    EXPECT_LE(errors.Inside.Value, InsideTolerances * v.GetTolerance())
      << v.GetName() << "\n  " << errors.Inside.Where;
    EXPECT_GT(errors.Fine, 0) << v.GetName();
    EXPECT_GT(errors.Pieces, errors.Fine) << v.GetName();
  });
}

TEST_P(Refined, PiecesCoverATriangleOnce)
{
  InAllViews(this->GetParam(), [](const RefinedView& v) {
    Shapes shapes(v.GetView());
    Cover cover;
    for (int i = 0; i < TrianglesOfView; i++)
    {
      MeasureCover(v, shapes.Make(i), shapes, cover);
    }
    EXPECT_EQ(cover.Uncovered, 0) << v.GetName() << ", " << cover.Pixels << " px from a tear\n  "
                                  << cover.Where;
    EXPECT_EQ(cover.Twice, 0) << v.GetName();
    EXPECT_EQ(cover.Turned, 0) << v.GetName();
  });
}

TEST_P(Refined, TwoTrianglesHaveTheSameChordsAtTheirEdge)
{
  InAllViews(this->GetParam(), [](const RefinedView& v) {
    Shapes shapes(v.GetView());
    long chords = 0;
    long besideFine = 0;
    Worst alone;
    for (int i = 0; i < TrianglesOfView; i++)
    {
      const Triangle t = shapes.Make(i);
      // the neighbour is as large, or so small that it may be fine, or so large that it is not
      const double size = std::pow(10, 2 * shapes.Unit());
      const vec3 top = t[0] + size * glm::length(t[1] - t[0]) * shapes.Vector();
      const Triangle neighbours[2] = { { t[1], t[0], top }, { top, t[1], t[0] } };
      const Triangle& u = neighbours[i % 2];
      const Chords mine = ChordsOfEdge(v, t, 2);
      const Chords others = ChordsOfEdge(v, u, i % 2 ? 0 : 2);
      chords += static_cast<long>(mine.size());
      besideFine += v.IsFine(t) != v.IsFine(u);
      alone.Take(CountAlone(v, mine, others) + CountAlone(v, others, mine), t);
    }
    EXPECT_EQ(alone.Value, 0) << v.GetName() << "\n  " << alone.Where;
    EXPECT_GT(chords, TrianglesOfView / 3) << v.GetName();
    EXPECT_GT(besideFine, 0) << v.GetName();
  });
}

namespace
{
// As the module asks it of a cluster.
Refiner::Need NeedOf(const RefinedView& v, const std::vector<Triangle>& cluster)
{
  Box box;
  double edge = 0;
  for (const Triangle& t : cluster)
  {
    for (int i = 0; i < 3; i++)
    {
      box.Add(t[i]);
      edge = std::max(edge, glm::length(t[i] - t[(i + 1) % 3]));
    }
  }
  return v.GetRefiner().OfCluster(box, 0.5 * glm::length(box.High - box.Low), edge);
}
}

TEST_P(Refined, ClustersSayWhatTheirTrianglesDo)
{
  InAllViews(this->GetParam(), [](const RefinedView& v) {
    Shapes shapes(v.GetView());
    std::map<Refiner::Need, long> needs;
    long coarse = 0;
    long seen = 0;
    for (int i = 0; i < ClustersOfView; i++)
    {
      const std::vector<Triangle> cluster = shapes.MakeCluster(i);
      const Refiner::Need need = NeedOf(v, cluster);
      needs[need]++;
      for (const Triangle& t : cluster)
      {
        const vec3 w = shapes.Weights();
        coarse += need == Refiner::Nothing && !v.IsFine(t);
        seen += need == Refiner::Unseen && v.IsSeen(t[0] * w.x + t[1] * w.y + t[2] * w.z);
      }
    }
    EXPECT_EQ(coarse, 0) << v.GetName() << ": triangles of fine clusters that are not fine";
    EXPECT_EQ(seen, 0) << v.GetName() << ": places of culled clusters that can be seen";
    EXPECT_GT(needs[Refiner::Nothing], 0) << v.GetName();
    EXPECT_GT(needs[Refiner::Unseen], 0) << v.GetName();
    EXPECT_GT(needs[Refiner::Some], 0) << v.GetName();
  });
}

// Of each family; the others take long.
INSTANTIATE_TEST_SUITE_P(All, Refined, testing::ValuesIn(NamesOfFamilies()),
  [](const auto& info) { return NameOfProjection(info.param); });
INSTANTIATE_TEST_SUITE_P(Other, Refined, testing::ValuesIn(NamesOfOthers()),
  [](const auto& info) { return NameOfProjection(info.param); });
