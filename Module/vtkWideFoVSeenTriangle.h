// SPDX-License-Identifier: BSD-3-Clause
// A triangle as an eye sees it, and whether it stands behind what was drawn.
#ifndef vtkWideFoVSeenTriangle_h
#define vtkWideFoVSeenTriangle_h

#include "vtkWideFoVDepthPicture.h"
#include "vtkWideFoVRayBlocks.h"
#include "vtkWideFoVSampleRays.h"
#include "vtkWideFoVSortWork.h"

#include <algorithm>
#include <cmath>

namespace wfv
{
namespace sorting
{
// One of the eyes that triangles are sorted for, and what it saw.
struct Watcher
{
  Watcher(const SortView& view, int eye, const DepthPicture* depths, const RayBlocks& blocks)
    : View(view.GetViewOf(eye))
    , Judge(view, eye)
    , Depths(depths)
    , Blocks(blocks)
  {
  }

  WfvView View;
  TriangleJudge Judge;
  LastSeen Seen;
  const DepthPicture* Depths;
  const RayBlocks& Blocks; // empty where none of what may be anywhere is looked at
};

// The pixels that a triangle may be drawn at: nearly inside its chords, so much farther out.
class ChordTriangle
{
public:
  ChordTriangle(const TriangleJudge::Corner c[3], double grow)
  {
    const vec2 a = c[1].At - c[0].At;
    const vec2 b = c[2].At - c[0].At;
    const double turn = a.x * b.y - a.y * b.x < 0 ? -1 : 1;
    for (int i = 0; i < 3; i++)
    {
      const vec2 side = c[(i + 1) % 3].At - c[i].At;
      this->Across[i] = turn * vec2(-side.y, side.x);
      this->Least[i] = glm::dot(this->Across[i], c[i].At) - grow * glm::length(side);
    }
  }

  bool Holds(const vec2& at) const
  {
    return glm::dot(this->Across[0], at) >= this->Least[0] &&
      glm::dot(this->Across[1], at) >= this->Least[1] &&
      glm::dot(this->Across[2], at) >= this->Least[2];
  }

private:
  vec2 Across[3];
  double Least[3];
};

// The rays that meet a triangle, or nearly. Of those that do not begin in the origin the moment
// counts as well.
class RayTriangle
{
public:
  // moved: by which corners may be drawn elsewhere, scene units
  RayTriangle(const TriangleJudge::Corner c[3], double moved)
    : Normal(glm::normalize(glm::cross(c[1].Place - c[0].Place, c[2].Place - c[0].Place)))
    , Ahead(glm::dot(this->Normal, c[0].Place))
  {
    for (int i = 0; i < 3; i++)
    {
      const vec3& from = c[i].Place;
      const vec3& to = c[(i + 1) % 3].Place;
      this->Edges[i] = glm::cross(from, to);
      this->Spans[i] = to - from;
      this->Slack[i] = RaySlack * (glm::length(this->Edges[i]) + glm::length(this->Spans[i])) +
        moved * (glm::length(from) + glm::length(to));
    }
  }

  bool Meets(const vec3& start, const vec3& direction) const
  {
    const vec3 moment = glm::cross(start, direction);
    const double turn = this->GetAhead(start) < 0 ? -1 : 1;
    for (int i = 0; i < 3; i++)
    {
      if (turn * this->GetInside(i, direction, moment) < -this->Slack[i])
      {
        return false;
      }
    }
    return true;
  }

  // False where none of the rays of a square does.
  bool MayMeet(const RayBlocks::Block& block) const
  {
    const double ahead = this->GetAhead(block.Start);
    const vec3 moment = glm::cross(block.Start, block.Direction);
    const double aside = block.Aside + glm::length(block.Start) * block.Angle; // of the moments
    const double turn = ahead < 0 ? -1 : 1;
    bool missed = false;
    for (int i = 0; i < 3; i++)
    {
      const double slack = this->Slack[i] + glm::length(this->Edges[i]) * block.Angle +
        glm::length(this->Spans[i]) * aside;
      missed = missed || turn * this->GetInside(i, block.Direction, moment) < -slack;
    }
    // of a square from which both sides may be seen nobody knows
    return !missed || !(std::abs(ahead) > block.Aside);
  }

  // How far the plane is ahead of a place.
  double GetAhead(const vec3& start) const { return this->Ahead - glm::dot(this->Normal, start); }

  // Of a ray with the plane.
  double GetSine(const vec3& direction) const { return glm::dot(this->Normal, direction); }

private:
  // On which side of an edge a ray passes, and how far, times lengths.
  double GetInside(int edge, const vec3& direction, const vec3& moment) const
  {
    return glm::dot(this->Edges[edge], direction) + glm::dot(moment, this->Spans[edge]);
  }

  // Radians that float32 may turn a ray or an edge by, and more.
  static constexpr double RaySlack = 1e-6;

  vec3 Normal;
  double Ahead;
  vec3 Edges[3];
  vec3 Spans[3];
  double Slack[3];
};

// A triangle in a view, and whether anything of it may be seen.
class SeenTriangle
{
public:
  // reach: pixels that it is moved out by to cover it; 0: a plain one
  SeenTriangle(const SortView& view, const Watcher& eye, const SampleRays& rays,
    const TriangleJudge::Corner c[3], bool covered, double reach)
    : V(view)
    , Eye(eye)
    , Rays(rays)
    , Covered(covered)
    , Nearest(FindNearest(view, eye, c))
    , Chords(c, (covered ? reach : FindMoved(view, c)) + PlainSlack)
    , Plane(c, view.Rounding)
  {
  }

  // The same of all pixels of a square.
  bool MayShow(const RayBlocks::Block& block) const { return this->Plane.MayMeet(block); }

  // True where it may be drawn at a pixel, and is not surely behind what is seen there.
  bool MayShow(int x, int y, bool anywhere) const
  {
    if (!anywhere && !this->Chords.Holds(vec2(x + 0.5, y + 0.5)))
    {
      return false;
    }
    const vec3 direction = this->Rays.GetDirection(x, y);
    if (direction == vec3(0))
    {
      return false;
    }
    const vec3 start = this->V.Own ? this->V.Own->EyeAt(direction, this->Eye.View) : vec3(0);
    if (this->Covered && !this->Plane.Meets(start, direction))
    {
      return false;
    }
    const double sine = this->Plane.GetSine(direction);
    const double moved = 2 * this->V.Rounding / std::abs(sine);
    const double least = this->GetLeast(this->Plane.GetAhead(start) / sine - moved, std::abs(sine));
    return !this->IsBeyond(least, this->Eye.Depths->GetDepth(x, y));
  }

private:
  // Over a distance: what float32 may move it by, where the ray meets the plane at no less than
  // this sine.
  static constexpr double DepthSlack = 1e-4;
  static constexpr double LeastSine = 2e-3;

  // Radians, and what is added to a sine: a little more than a hair, and WFV_STEEP
  // (order_fragment.glsl).
  static constexpr double Hair = 6e-6;
  static constexpr double Steep = 0.02;

  // Window depth: ten steps of a buffer of 24 bits, for rounding, WFV_BEHIND (cover_fragment.glsl)
  // and WFV_BACK_YIELDS (order_fragment.glsl).
  static constexpr double DepthSteps = 10.0 / (1 << 24);

  // Sines under which a plain triangle surely has the depth of a place, and from which on that of
  // the ray: WFV_LEAST_SINE (depth_fragment.glsl), by a length that is up to 1.73 times the
  // normal's.
  static constexpr double LeastRaySine = 0.009;
  static constexpr double SureRaySine = 0.02;

  // Pixels that a plain triangle may be off its edges, rasterized.
  static constexpr double PlainSlack = 0.05;

  // Of places between corners the squared distance is no less than that of the nearest corner, by a
  // third of the squared longest edge.
  static double FindNearest(
    const SortView& view, const Watcher& eye, const TriangleJudge::Corner c[3])
  {
    const vec3 p[3] = { c[0].Place, c[1].Place, c[2].Place };
    const double corners =
      std::min({ glm::dot(p[0], p[0]), glm::dot(p[1], p[1]), glm::dot(p[2], p[2]) });
    const double circle = view.Own ? eye.View.stereo.x : 0;
    const double nearest = corners - TriangleJudge::Longest2(p) / 3 - circle * circle;
    return std::sqrt(std::max(nearest, 0.0)) - 2 * view.Rounding;
  }

  // Pixels by which the vertex buffer may move the corners of a plain triangle: nothing of it is
  // much more stretched than its longest edge.
  static double FindMoved(const SortView& view, const TriangleJudge::Corner c[3])
  {
    const vec3 p[3] = { c[0].Place, c[1].Place, c[2].Place };
    const double longest = std::max({ glm::length(c[1].At - c[0].At),
      glm::length(c[2].At - c[1].At), glm::length(c[0].At - c[2].At) });
    const double moved = 4 * view.Rounding * longest / std::sqrt(TriangleJudge::Longest2(p));
    return view.Rounding > 0 ? moved : 0;
  }

  // True where a distance is farther than a window depth, whatever rounding does.
  bool IsBeyond(double distance, double depth) const
  {
    return distance > this->Eye.View.radii.x &&
      wfvDepthOf(distance * (1 - DepthSlack), this->Eye.View) - DepthSteps > depth;
  }

  // What is drawn at a ray that meets its plane there, at the least. Of a plain triangle that is by
  // the ray as well, or, seen nearly edge-on, by a place of it beside (depth_fragment.glsl).
  double GetLeast(double distance, double sine) const
  {
    if (this->Covered)
    {
      return sine >= LeastSine ? distance * (1 - Hair / (sine + Steep)) : 0;
    }
    const double beside = PlainSlack * 2 * WFV_PI / std::min(this->V.Pixels.x, this->V.Pixels.y);
    const double byRay = sine > beside ? distance * (1 - 2 * beside / sine) : 0;
    return sine < LeastRaySine ? this->Nearest
      : sine < SureRaySine     ? std::min(this->Nearest, byRay)
                               : byRay;
  }

  const SortView& V;
  const Watcher& Eye;
  const SampleRays& Rays;
  const bool Covered;
  const double Nearest;
  const ChordTriangle Chords;
  const RayTriangle Plane;
};
}
}

#endif
