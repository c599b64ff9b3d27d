// SPDX-License-Identifier: BSD-3-Clause
#include "Projections/Bounds/Visibility.h"

#include <algorithm>
#include <cmath>

namespace wfv
{
namespace
{
// Relative: what float32 makes of distances, and of the rim of a round map.
constexpr double Rounding = 1e-5;

struct Range
{
  double Low;
  double High;
};

// Distances of a rectangle of a plane from its origin.
Range RadiiOf(const Range& u, const Range& v)
{
  return { std::hypot(std::max({ u.Low, -u.High, 0.0 }), std::max({ v.Low, -v.High, 0.0 })),
    std::hypot(std::max(-u.Low, u.High), std::max(-v.Low, v.High)) };
}

// Range of atan2(v, u): all round where the rectangle holds the origin, else less than pi wide,
// and possibly beyond pi or -pi.
Range TurnsOf(const Range& u, const Range& v)
{
  if (u.Low <= 0 && u.High >= 0 && v.Low <= 0 && v.High >= 0)
  {
    return { -WFV_PI, WFV_PI };
  }
  const double middle = std::atan2(0.5 * (v.Low + v.High), 0.5 * (u.Low + u.High));
  Range turns{ middle, middle };
  for (int i = 0; i < 4; i++)
  {
    const double angle = std::atan2(i & 1 ? v.Low : v.High, i & 2 ? u.Low : u.High);
    const double off = std::remainder(angle - middle, 2 * WFV_PI);
    turns = { std::min(turns.Low, middle + off), std::max(turns.High, middle + off) };
  }
  return turns;
}

bool Meets(const vec4& bounds, const Window& w)
{
  const vec2 low = w.Low - w.Footprint;
  const vec2 high = w.High + w.Footprint;
  // written so that what is no number meets
  return !(bounds.x > high.x || bounds.z < low.x || bounds.y > high.y || bounds.w < low.y);
}

// Where a box may be in a map of meridians; footprint: of what is drawn wide, beyond its place.
Pictures PicturesOnMeridians(
  const Projection& p, const WfvView& v, const Box& b, const vec2& footprint)
{
  const Range x{ b.Low.x, b.High.x };
  const Range ahead{ -b.High.z, -b.Low.z };
  const Range flat = RadiiOf(x, ahead);
  const Range lambda = TurnsOf(ahead, x);
  // what reaches over the seam shows at the other border as well
  const bool both = footprint.x > 0 && std::max(-lambda.Low, lambda.High) > 0.5 * WFV_PI;
  const double endX = glm::radians(0.5 * p.MaxHorizontalFov);
  const double endY = glm::radians(0.5 * p.MaxVerticalFov);
  const double low = std::atan2(b.Low.y, b.Low.y < 0 ? flat.Low : flat.High);
  const double high = std::atan2(b.High.y, b.High.y < 0 ? flat.High : flat.Low);
  Pictures pictures;
  for (int turn = -1; turn <= 1; turn++)
  {
    const double from = lambda.Low + 2 * WFV_PI * turn;
    const double to = lambda.High + 2 * WFV_PI * turn;
    if ((to < -WFV_PI || from > WFV_PI) && !both)
    {
      continue;
    }
    const vec4 angles(std::clamp(from, -endX, endX), std::clamp(low, -endY, endY),
      std::clamp(to, -endX, endX), std::clamp(high, -endY, endY));
    pictures.Add(p.Bounds(angles, v));
  }
  return pictures;
}

Pictures PicturesOnRoundMap(
  const Projection& p, const WfvView& v, const Box& b, const vec2& footprint)
{
  const Range x{ b.Low.x, b.High.x };
  const Range y{ b.Low.y, b.High.y };
  const Range ahead{ -b.High.z, -b.Low.z };
  const Range radii = RadiiOf(x, y);
  const double nearest = std::atan2(ahead.High > 0 ? radii.Low : radii.High, ahead.High);
  const double farthest = std::atan2(ahead.Low > 0 ? radii.High : radii.Low, ahead.Low);
  // what is wide shows inside a rim that its place is outside of
  const double outside =
    p.Map(vec2(0, std::max(nearest, v.maxAngle)), v).x - p.Map(vec2(0, v.maxAngle), v).x;
  Pictures pictures;
  if (nearest > v.maxAngle * (1 + Rounding) && outside >= footprint.x)
  {
    return pictures;
  }
  const double end = footprint.x > 0 ? WFV_PI : v.maxAngle;
  const Range azimuth = TurnsOf(x, y);
  pictures.Add(
    p.Bounds(vec4(azimuth.Low, std::min(nearest, end), azimuth.High, std::min(farthest, end)), v));
  return pictures;
}
}

Pictures PicturesOf(const Projection& p, const WfvView& v, const Box& b, const vec2& footprint)
{
  switch (p.Axis)
  {
    case Family::Meridian:
      return PicturesOnMeridians(p, v, b, footprint);
    case Family::Azimuthal:
      return PicturesOnRoundMap(p, v, b, footprint);
    default:
    {
      Pictures pictures;
      pictures.Add(vec4(-1, -1, 1, 1));
      return pictures; // the faces of a cube show all directions; of a table nothing is said
    }
  }
}

vec2 Distances(const Box& b)
{
  const Range flat = RadiiOf({ b.Low.x, b.High.x }, { b.Low.z, b.High.z });
  return vec2(std::hypot(flat.Low, std::max({ b.Low.y, -b.High.y, 0.0 })),
    std::hypot(flat.High, std::max(-b.Low.y, b.High.y)));
}

bool IsBetweenClips(const WfvView& v, const Box& b)
{
  const vec2 distances = Distances(b);
  return !(distances.x > v.radii.y * (1 + Rounding) || distances.y < v.radii.x * (1 - Rounding));
}

bool ShowsAll(const Projection& p, const WfvView& v, const Window& w)
{
  vec4 all;
  switch (p.Axis)
  {
    case Family::Meridian:
    {
      const double endX = glm::radians(0.5 * p.MaxHorizontalFov);
      const double endY = glm::radians(0.5 * p.MaxVerticalFov);
      all = p.Bounds(vec4(-endX, -endY, endX, endY), v);
      break;
    }
    case Family::Azimuthal:
      if (!(v.maxAngle >= WFV_PI))
      {
        return false;
      }
      all = p.Bounds(vec4(-WFV_PI, 0, WFV_PI, WFV_PI), v);
      break;
    default:
      return true; // as IsCulled says
  }
  return w.Low.x <= all.x && w.Low.y <= all.y && w.High.x >= all.z && w.High.y >= all.w;
}

bool IsCulled(const Projection& p, const WfvView& v, const Box& b, const Window& w)
{
  if (!IsBetweenClips(v, b))
  {
    return true;
  }
  if (p.Axis != Family::Meridian && p.Axis != Family::Azimuthal)
  {
    return false;
  }
  const Pictures pictures = PicturesOf(p, v, b, w.Footprint);
  return std::none_of(pictures.Bounds.begin(), pictures.Bounds.begin() + pictures.Count,
    [&w](const vec4& bounds) { return Meets(bounds, w); });
}
}
