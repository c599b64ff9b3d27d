// SPDX-License-Identifier: BSD-3-Clause
// How far the edges of a triangle are off its chords, and the shape that holds it.
#include "vtkWideFoVTriangleJudge.h"

#include "Projections/Bend.h"

#include <algorithm>
#include <cmath>

namespace wfv
{
// `most` on both sides for all that is more than that.
TriangleJudge::Bulge TriangleJudge::MeasureEdge(const Corner& a, const Corner& b, double most) const
{
  const vec3 chord = b.Direction - a.Direction;
  const double sine = std::min({ 1.0, SineToSingularity(this->V.Map->Axis, a.Direction),
    SineToSingularity(this->V.Map->Axis, b.Direction) });
  const bool little =
    glm::dot(chord, chord) <= Square(std::min(LongestMeasured, PartOfSine * sine));
  const int parts = little ? 4 : 8;
  const vec2 along = b.At - a.At;
  const double length = glm::length(along);
  Bulge off;
  for (int i = 1; i < parts; i++)
  {
    const double t = double(i) / parts;
    const vec3 place = this->V.Own ? this->See(a.Place * (1 - t) + b.Place * t).Direction
                                   : glm::normalize(a.Direction * (1 - t) + b.Direction * t);
    const vec2 at = this->V.Samples.At(this->V.Map->Project(place, this->V.View)) - a.At;
    // of a chord without length all that is seen is beyond its ends
    const double way = length > 0 ? glm::dot(along, at) / length : glm::length(at);
    const double left = length > 0 ? (along.x * at.y - along.y * at.x) / length : 0;
    off.Left = std::max(off.Left, left);
    off.Right = std::max(off.Right, -left);
    off.Ends = std::max({ off.Ends, way - length, -way });
    if (!(off.GetMost() < most))
    {
      return { most, most, 0 };
    }
  }
  const double between = (BetweenParts - 1) * off.GetMost();
  const double ends = off.Ends > 0 ? off.Ends + between : 0;
  return { off.Left + between, off.Right + between, ends };
}

// A triangle is between its chords and what bulges out from them. Of one so thin that its edges may
// have changed sides that is not so: all sides move by all that any edge is off.
unsigned int TriangleJudge::GetReach(
  const Corner* const c[3], const Bulge off[3], double sure) const
{
  const vec2 a = c[1]->At - c[0]->At;
  const vec2 b = c[2]->At - c[0]->At;
  const double twice = a.x * b.y - a.y * b.x;
  const double longest = std::max({ glm::length(a), glm::length(b), glm::length(b - a) });
  const double most = std::max({ off[0].GetMost(), off[1].GetMost(), off[2].GetMost() });
  const bool thin = !(std::abs(twice) > 2 * sure * longest) || IsTurned(c) ||
    GetSide(c[0]->Place, c[1]->Place, c[2]->Place) == 0;
  const double ends = std::max({ off[0].Ends, off[1].Ends, off[2].Ends });
  unsigned int reach = 0;
  for (int i = 0; i < 3; i++)
  {
    const Bulge& edge = off[(i + 1) % 3]; // from the next corner to the one after it
    const double out = thin ? most : (twice > 0 ? edge.Right : edge.Left) + ends;
    reach |= static_cast<unsigned int>(std::ceil(Reaches * (out + sure))) << (ReachBits * i);
  }
  return reach;
}

unsigned int TriangleJudge::JoinReaches(unsigned int a, unsigned int b)
{
  unsigned int both = 0;
  for (int i = 0; i < 3; i++)
  {
    const unsigned int side = ((1u << ReachBits) - 1) << (ReachBits * i);
    both |= std::max(a & side, b & side);
  }
  return both;
}

double TriangleJudge::GetCalmArea(const Corner* const c[3], unsigned int reach)
{
  const vec2 a = c[1]->At - c[0]->At;
  const vec2 b = c[2]->At - c[0]->At;
  const double area = 0.5 * std::abs(a.x * b.y - a.y * b.x);
  double longest = 0;
  double most = 0;
  double times = 1;
  for (int i = 0; i < 3; i++)
  {
    const double side = glm::length(c[(i + 2) % 3]->At - c[(i + 1) % 3]->At);
    const double grow = ((reach >> (ReachBits * i)) & ((1u << ReachBits) - 1)) / Reaches;
    longest = std::max(longest, side);
    most = std::max(most, grow);
    times += grow * side / (2 * area);
  }
  return std::min(area * times * times, (longest + 2 * most) * (2 * area / longest + 2 * most));
}
}
