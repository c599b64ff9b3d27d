// SPDX-License-Identifier: BSD-3-Clause
// What triangles are classed as holds: of those that are projected, as they are or cut, no edge is
// farther from its chords in the picture than the tolerance, and nothing is torn.
#include "Clusters/Classifier.h"
#include "Stereo/Stereo.h"
#include "Views.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <memory>
#include <random>
#include <string>
#include <vector>

using namespace wfv;
using namespace wfv::test;

namespace
{
constexpr int TrianglesOfView = 6000;
constexpr int ClustersOfView = 2000;
constexpr int TrianglesOfCluster = 30;
constexpr int PlacesOfPart = 7;  // of an edge, between the ends of a chord
constexpr int PlacesInside = 12; // a triangle

// Pixels: what is torn is drawn farther from its place than this.
constexpr double TornPixels = 8;

const vec2 Size(1024, 512);

// Random triangles and clusters of all sizes: many where the view looks, some beside a pole or a
// seam.
class Shapes
{
public:
  using Triangle = std::array<vec3, 3>;

  explicit Shapes(const View& view)
    : TheView(view)
  {
  }

  double Unit() { return this->Distribution(this->Engine); }
  vec3 Vector() { return vec3(this->Unit(), this->Unit(), this->Unit()); }

  vec3 Direction(int number)
  {
    const vec3 d = glm::normalize(this->Vector());
    const ViewRay ray = this->TheView.Ray(vec2(this->Unit(), this->Unit()));
    switch (number % 5)
    {
      case 0: // a pole
        return glm::normalize(vec3(0, d.y < 0 ? -1 : 1, 0) + 0.3 * d);
      case 1: // the seam and the antipode
        return glm::normalize(vec3(0.05 * d.x, d.y, 1));
      case 2:
        return d;
      default:
        return ray.Inside ? ray.Direction : d;
    }
  }

  // So far away, its size and its width of that.
  Triangle MakeAt(const vec3& at, double distance, double size, double width)
  {
    const vec3 along = glm::normalize(glm::cross(at, this->Vector()));
    const vec3 across = glm::cross(at, along);
    Triangle t;
    for (vec3& p : t)
    {
      const vec3 step = along * this->Unit() + across * (width * this->Unit());
      p = distance * (at + size * step + at * (0.5 * size * this->Unit()));
    }
    return t;
  }

  Triangle Make(int number)
  {
    const double size = std::pow(10, -1.6 + 1.4 * this->Unit());
    const double width = number % 3 ? std::pow(10, -1 + this->Unit()) : 1;
    return this->MakeAt(this->Direction(number), this->Distance(), size, width);
  }

  std::vector<Triangle> MakeCluster(int number)
  {
    const vec3 at = this->Direction(number);
    const double distance = this->Distance();
    const double radius = std::pow(10, -1.5 + this->Unit());
    const double size = radius * std::pow(10, -0.5 + 0.5 * this->Unit());
    std::vector<Triangle> all(TrianglesOfCluster);
    for (Triangle& t : all)
    {
      const vec3 place = at + radius * this->Vector();
      t = this->MakeAt(glm::normalize(place), distance * glm::length(place), size, 1);
    }
    return all;
  }

private:
  double Distance() { return std::pow(10, 2 * this->Unit()); }

  const View& TheView;
  std::mt19937_64 Engine{ 21 };
  std::uniform_real_distribution<double> Distribution{ -1, 1 };
};

// A view and what classifies in it.
struct Classified
{
  explicit Classified(const Projection& p, const ViewOptions& o, double tolerance)
    : TheView(p, o)
  {
    const WfvView& v = this->TheView.GetParameters();
    const StereoModel* const model = this->TheView.GetStereoModel();
    const bool own = model && !model->Traits.OneCenter;
    this->V.Map = &this->TheView.GetProjection();
    this->V.View = v;
    this->V.View.eye = WFV_EYE_MIDDLE;
    this->V.Tolerance = tolerance;
    this->V.Culls = false;
    this->V.EyeRadius = own ? wfvFromMiddle(v) : 0;
    this->V.Stereo = own ? model : nullptr;
    this->V.Limits = std::make_shared<ChordLimits>(p, v, LocalCurvature(p, v), Size, tolerance);
    this->Classes.reset(new Classifier(this->V));
  }

  vec2 At(const vec3& p) const { return 0.5 * Size * vec2(this->TheView.Forward(p).Ndc); }

  // Where a place is shown, or is drawn at.
  bool IsSeen(const vec3& p, const vec2& drawn) const
  {
    const vec2 part = glm::abs(drawn) / (0.5 * Size);
    return this->TheView.Forward(p).Inside || std::max(part.x, part.y) <= 1;
  }

  View TheView;
  ClassifierView V;
  std::unique_ptr<Classifier> Classes;
};

struct Worst
{
  double Chord = 0; // pixels between an edge and its chords
  double Torn = 0;  // pixels between a place of a triangle and what is drawn for it
  long OutsideRadii = 0;
  std::string Where; // the triangle whose chords those are
  std::array<long, int(DrawClass::Mixed)> Counts{};
};

double DistanceToChord(const vec2& a, const vec2& b, const vec2& p)
{
  const vec2 way = b - a;
  const double length2 = glm::dot(way, way);
  const double t = length2 > 0 ? std::clamp(glm::dot(p - a, way) / length2, 0.0, 1.0) : 0;
  return glm::length(p - a - t * way);
}

double EdgeError(const Classified& c, const vec3& p, const vec3& q, int chords)
{
  double worst = 0;
  for (int part = 0; part < chords; part++)
  {
    const vec3 from = glm::mix(p, q, part / double(chords));
    const vec3 to = glm::mix(p, q, (part + 1) / double(chords));
    const vec2 a = c.At(from);
    const vec2 b = c.At(to);
    for (int i = 1; i <= PlacesOfPart; i++)
    {
      const double t = i / (PlacesOfPart + 1.0);
      const vec3 at = glm::mix(from, to, t);
      const bool seen = c.IsSeen(at, glm::mix(a, b, t));
      worst = std::max(worst, seen ? DistanceToChord(a, b, c.At(at)) : 0);
    }
  }
  return worst;
}

// Rows that a triangle is cut into at the most: those of a strip, or of a grid.
int RowsOf(const Classifier::Triangle& t)
{
  const int least = std::min({ t.Chords[0], t.Chords[1], t.Chords[2] });
  return t.Class == DrawClass::Projected ? 1
    : least > 1                          ? Classifier::MostRows
                                         : Classifier::MostChords;
}

// Pixels between a place inside and where the small triangle round it is drawn, of a grid of so
// many rows.
void LookInside(
  const Classified& c, const Shapes::Triangle& t, int rows, Shapes& shapes, Worst& worst)
{
  const double first = std::abs(shapes.Unit());
  const double second = std::abs(shapes.Unit()) * (1 - first);
  // the corners of the small one, or of the one turned round beside it
  const vec2 scaled(rows * first, rows * second);
  const vec2 low = glm::floor(scaled);
  const vec2 in = scaled - low;
  const double turned = in.x + in.y > 1 ? 1 : 0;
  const auto at = [&](const vec2& w) {
    return t[0] + (w.x / rows) * (t[1] - t[0]) + (w.y / rows) * (t[2] - t[0]);
  };
  const vec3 p = at(scaled);
  const vec2 shares = turned > 0 ? vec2(1 - in.x, 1 - in.y) : in;
  const vec2 step(turned > 0 ? -1 : 1);
  const vec2 corner = low + turned;
  const vec2 drawn = (1 - shares.x - shares.y) * c.At(at(corner)) +
    shares.x * c.At(at(corner + vec2(step.x, 0))) + shares.y * c.At(at(corner + vec2(0, step.y)));
  if (c.IsSeen(p, drawn))
  {
    worst.Torn = std::max(worst.Torn, glm::length(c.At(p) - drawn));
    const double distance = glm::length(p);
    const vec2 radii = c.V.View.radii;
    worst.OutsideRadii += distance < radii.x || distance > radii.y;
  }
}

void LookAt(const Classified& c, const Shapes::Triangle& t, Shapes& shapes, Worst& worst)
{
  const Classifier::Triangle found = c.Classes->OfTriangle(t[0], t[1], t[2]);
  worst.Counts[int(found.Class)]++;
  // the same from the other end, and whichever triangle asks
  const vec3 other = t[0] + shapes.Vector();
  EXPECT_EQ(c.Classes->OfTriangle(t[2], t[1], other).Chords[2], found.Chords[0]);
  EXPECT_EQ(c.Classes->OfTriangle(other, t[1], t[2]).Chords[0], found.Chords[0]);
  if (found.Class == DrawClass::RayTested)
  {
    return;
  }
  for (int i = 0; i < 3; i++)
  {
    EXPECT_TRUE(found.Chords[i] >= 1 && found.Chords[i] <= RowsOf(found));
    const double error = EdgeError(c, t[(i + 1) % 3], t[(i + 2) % 3], found.Chords[i]);
    if (error > worst.Chord)
    {
      worst.Chord = error;
      worst.Where = Text(t[0]) + ", " + Text(t[1]) + ", " + Text(t[2]) + " edge " +
        std::to_string(i) + " of " + std::to_string(found.Chords[i]);
    }
  }
  for (int i = 0; i < PlacesInside; i++)
  {
    LookInside(c, t, RowsOf(found), shapes, worst);
  }
}

void Check(const Classified& c, const std::string& name)
{
  Shapes shapes(c.TheView);
  Worst worst;
  for (int i = 0; i < TrianglesOfView; i++)
  {
    LookAt(c, shapes.Make(i), shapes, worst);
  }
  const auto& n = worst.Counts;
  const long projected = n[int(DrawClass::Projected)];
  std::cout << name << ": " << projected << " projected, " << n[int(DrawClass::Cut)] << " cut, of "
            << TrianglesOfView << "; chords " << worst.Chord << " px, inside " << worst.Torn
            << " px" << std::endl;
  EXPECT_LE(worst.Chord, c.V.Tolerance) << name << "\n  " << worst.Where;
  EXPECT_LE(worst.Torn, TornPixels) << name;
  EXPECT_EQ(worst.OutsideRadii, 0) << name;
  EXPECT_GT(projected, TrianglesOfView / 50) << name;
}

ViewOptions OptionsOf(const Projection& p, double part)
{
  ViewOptions o;
  o.HorizontalFov = std::max(p.MinHorizontalFov, part * p.MaxHorizontalFov);
  o.VerticalFov = std::max(p.MinVerticalFov, part * p.MaxVerticalFov);
  o.Radii = { { 0.1, 50 } };
  return o;
}

// calls(classified, name, part of the widest): of every projection, narrow and wide, at two
// tolerances.
template <typename Calls>
void InAllViews(const Calls& calls)
{
  for (const Projection& p : Projections())
  {
    for (const double part : { 0.3, 1.0 })
    {
      for (const double tolerance : { 0.25, 1.0 })
      {
        const Classified c(p, OptionsOf(p, part), tolerance);
        calls(c, MakeView(p, OptionsOf(p, part)).Name + ", " + std::to_string(tolerance), part);
      }
    }
  }
}
}

TEST(Classifier, ChordsKeepTheToleranceAndNothingTears)
{
  InAllViews([](const Classified& c, const std::string& name, double) { Check(c, name); });
}

TEST(Classifier, ChordsKeepTheToleranceForAnEyeOnACircle)
{
  for (const Projection& p : Projections())
  {
    ViewOptions o = OptionsOf(p, 1);
    o.Stereo.Model = FindStereoModel("omnidirectional");
    o.Stereo.InterpupillaryDistance = 0.065;
    o.Stereo.Eye = Eye::Left;
    if (p.Axis != Family::Planar)
    {
      Check(Classified(p, o, 0.25), p.Name);
    }
  }
}

namespace
{
// As the module asks it of a cluster.
DrawClass ClassOf(const Classified& c, const std::vector<Shapes::Triangle>& cluster)
{
  Box box;
  double edge = 0;
  for (const Shapes::Triangle& t : cluster)
  {
    for (int i = 0; i < 3; i++)
    {
      box.Add(t[i]);
      edge = std::max(edge, glm::length(t[i] - t[(i + 1) % 3]));
    }
  }
  return c.Classes->OfCluster(box, 0.5 * glm::length(box.High - box.Low), edge);
}
}

TEST(Classifier, ProjectsWhatIsInAProjectedCluster)
{
  InAllViews([](const Classified& c, const std::string& name, double part) {
    Shapes shapes(c.TheView);
    long projected = 0;
    long others = 0;
    for (int i = 0; i < ClustersOfView; i++)
    {
      const std::vector<Shapes::Triangle> cluster = shapes.MakeCluster(i);
      if (ClassOf(c, cluster) == DrawClass::Projected)
      {
        projected++;
        others += std::count_if(cluster.begin(), cluster.end(), [&c](const auto& t) {
          return c.Classes->OfTriangle(t[0], t[1], t[2]).Class != DrawClass::Projected;
        });
      }
    }
    EXPECT_EQ(others, 0) << name;
    EXPECT_TRUE(projected > ClustersOfView / 100 || part < 1) << projected << " of " << name;
  });
}

// Without limits nothing is.
TEST(Classifier, ProjectsNothingWithoutLimits)
{
  const Projection& p = *FindProjection("equirectangular");
  Classified c(p, OptionsOf(p, 1), 0.25);
  c.V.Limits = nullptr;
  Shapes shapes(c.TheView);
  for (int i = 0; i < ClustersOfView; i++)
  {
    EXPECT_EQ(ClassOf(c, shapes.MakeCluster(i)), DrawClass::RayTested);
  }
}
