// SPDX-License-Identifier: BSD-3-Clause
#include "Refine/RefineSpace.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wfv
{
namespace
{
// Pixels: a shorter edge is never split. A triangle that holds a pole or an antipode is split until
// its edges are so short.
constexpr double TinyPixels = 1.0 / 32;

// Over the sine of the angle between a point's direction and that of the ray that meets it: what
// the level distance and the height add.
constexpr double AsideSafety = 1.4;

// Radians beyond the border of the picture.
constexpr double PlaneMargin = 1e-3;

// Radians beyond the largest angles that were found at places of the border of a picture.
constexpr double BorderMargin = 0.02;

// Radians: half a field of view of a planar map is taken for no more.
constexpr double MostPlanarAngle = 1.5707;

// Relative to the distance: rounding leaves ends in the plane of the seam so near it.
constexpr double OnSeam = 1e-9;

// Six times the volume between the eye and a triangle, over the product of the corners' distances:
// a triangle with less is seen edge-on.
constexpr double EdgeOn = 1e-14;

// Half widths of the picture by which an eye's picture may be moved.
constexpr double MostEyeShift = 0.5;

// Pixels of the picture beside a pole that may be left out for an eye on a circle.
constexpr double UnseenPixels = 1.0 / 8;

int TearsOf(Family family)
{
  switch (family)
  {
    case Family::Azimuthal:
      return WFV_TEARS_AZIMUTHAL;
    case Family::Planar:
      return WFV_TEARS_PLANAR;
    case Family::Faces:
      return WFV_TEARS_FACES;
    default:
      return WFV_TEARS_MERIDIAN;
  }
}

// How much more the rays of the eyes turn where their circle fades between two latitudes: by the
// first and the second derivative of the radius.
double FadeOf(const RefineView& view)
{
  const double range = view.View.stereo.y - view.View.stereo.x;
  const bool fades = view.Stereo && view.Stereo->Fades(view.View) && range > 0;
  return fades ? 1 + 3 / range + 6 / (range * range) : 1;
}

// NDC that a place moves for a unit of depth at the most, in a picture that is shifted by depth.
double DepthBendOf(const RefineView& view)
{
  if (!view.Stereo || view.Stereo->Traits.StraightRays)
  {
    return 0;
  }
  double most = 0;
  constexpr double step = 0.01;
  for (const double depth : { -1.0, 0.0, 1.0 - step })
  {
    for (const vec2& corner : { vec2(-1, -1), vec2(1, -1), vec2(-1, 1), vec2(1, 1) })
    {
      const vec2 moved = view.Stereo->Shift(corner, depth + step, view.View) -
        view.Stereo->Shift(corner, depth, view.View);
      most = std::max(most, glm::length(moved) / step);
    }
  }
  return 2 * most; // depth is from -1 to 1
}

// The largest azimuth, radians, and sine of the elevation of the border of a picture; false if the
// picture holds the end of the map. The angles have no maximum inside, but at a pole, above which
// the border is outside of the map.
bool FindBorder(const RefineView& view, double& azimuth, double& sine)
{
  azimuth = 0;
  sine = 0;
  constexpr int steps = 64;
  for (int i = -steps; i <= steps; i++)
  {
    const double s = static_cast<double>(i) / steps;
    for (const vec2& ndc : { vec2(s, -1), vec2(s, 1), vec2(-1, s), vec2(1, s) })
    {
      const WfvRay ray = view.Map->Unproject(ndc, view.View);
      if (!ray.inside)
      {
        return false;
      }
      const vec3& d = ray.direction;
      azimuth = std::max(azimuth, std::atan2(std::abs(d.x), -d.z));
      sine = std::max(sine, std::abs(d.y));
    }
  }
  return true;
}
}

RefineSpace::RefineSpace(const RefineView& view)
  : V(view)
  , AllAround(view.Culls && ShowsAll(*view.Map, view.View, view.Part))
  , wfvView(view.View)
  , wfvPicture(0, 0, view.Pixels.x, view.Pixels.y)
{
  const double pixel =
    2 * std::max(view.View.halfFov.x, view.View.halfFov.y) / std::max(view.Pixels.x, view.Pixels.y);
  this->wfvRefine.tears = TearsOf(view.Map->Axis);
  this->wfvRefine.tolerance = view.Tolerance;
  // a point so near the circle, at a distance h, is seen this part of a pixel from the pole
  this->wfvRefine.unseen =
    view.EyeRadius > 0 ? 0.5 * std::pow(UnseenPixels * pixel, 2) / view.EyeRadius : 0;
  this->wfvRefine.tinyAngle2 = std::pow(TinyPixels * view.Tolerance * pixel, 2);
  this->wfvRefine.circle = view.EyeRadius;
  this->wfvRefine.nearCircle = view.Stereo && view.Stereo->Fades(view.View) ? 0 : view.EyeRadius;
  this->NearReach = this->wfvNearReach(WFV_INSIDE);
  this->wfvRefine.fade = FadeOf(view);
  this->wfvRefine.depthBend = DepthBendOf(view);
  this->SetEnd();
  if (view.EyeRadius == 0 || view.Map->Axis == Family::Meridian)
  {
    this->SetPlanes();
  }
}

// Sets the end of a round or a planar map. A planar one ends between the corners of the picture and
// the plane of the eye.
void RefineSpace::SetEnd()
{
  const WfvView& v = this->V.View;
  const double round = std::min(WFV_PI, v.maxAngle + WFV_OUTSIDE_CHORD);
  const double moved =
    1 + std::max(std::abs(v.center.x), std::abs(v.center.y)) + (this->V.Stereo ? MostEyeShift : 0);
  const double corner = std::atan(moved *
    std::hypot(std::tan(std::min(v.halfFov.x, MostPlanarAngle)),
      std::tan(std::min(v.halfFov.y, MostPlanarAngle))));
  const bool planar = this->V.Map->Axis == Family::Planar;
  // beyond these rims a map folds back, so triangles are cut; others are left to the fragment stage
  const bool folds = this->V.Map->Axis == Family::Azimuthal &&
    (this->V.Map->FlatRim || v.lens.x != 0) && v.maxAngle < WFV_PI - 1e-4;
  const double pixels =
    0.5 * std::max(this->V.Pixels.x, this->V.Pixels.y) / std::max(0.1, v.maxAngle);
  this->wfvRefine.rimCosine = std::cos(v.maxAngle);
  this->wfvRefine.rimChord =
    folds ? 0.5 * std::sqrt(this->V.Tolerance * std::sin(v.maxAngle) / pixels) : 0;
  if (this->V.Map->Axis == Family::Azimuthal && v.maxAngle >= WFV_PI - 1e-4)
  {
    // nearer to the antipode an edge that is never split would turn too far along the rim, and a
    // chord of the rim between two such edges may be twice as long
    const double tiny = std::sqrt(this->wfvRefine.tinyAngle2);
    const double turn = 0.5 * std::sqrt(8 * this->V.Tolerance / (pixels * WFV_PI));
    this->wfvRefine.rimCosine = -std::cos(tiny / turn);
    this->wfvRefine.rimChord = tiny;
  }
  const double angle = std::acos(this->wfvRefine.rimCosine);
  const vec3 atRim(std::sin(angle), 0, -std::cos(angle));
  this->wfvRefine.rimPixels =
    this->wfvRefine.rimChord > 0 ? glm::length(this->wfvPixelOf(atRim, 1)) : 0;
  this->wfvRefine.beyondCosine = planar ? 0.5 * std::cos(corner) : std::cos(round);
  this->wfvRefine.endChord =
    std::min(WFV_LONGEST_CHORD, 0.5 * (std::acos(0.5 * std::cos(corner)) - corner));
}

// Planes through the eye, of whose outer sides nothing is in the picture.
void RefineSpace::SetPlanes()
{
  const vec2& half = this->V.View.halfFov;
  switch (this->V.Map->Axis)
  {
    case Family::Azimuthal:
    {
      const double angle = this->V.View.maxAngle + PlaneMargin;
      constexpr int planes = 8;
      for (int i = 0; i < planes && angle < 0.5 * WFV_PI; i++)
      {
        const double turn = 2 * WFV_PI * i / planes;
        this->Planes.push_back(vec3(
          std::cos(turn) * std::cos(angle), std::sin(turn) * std::cos(angle), std::sin(angle)));
      }
      break;
    }
    case Family::Planar:
      this->Planes.push_back(vec3(0, 0, 1));
      for (const double side : { -1.0, 1.0 })
      {
        if (this->V.Stereo || this->V.View.center != vec2(0))
        {
          break; // the picture is not in the middle
        }
        const vec2 angle = half + PlaneMargin;
        this->Planes.push_back(vec3(side * std::cos(angle.x), 0, std::sin(angle.x)));
        this->Planes.push_back(vec3(0, side * std::cos(angle.y), std::sin(angle.y)));
      }
      break;
    case Family::Meridian:
      this->SetMeridianEnds();
      break;
    default:
      break;
  }
}

// The meridians and the elevation beyond which nothing is in the picture.
void RefineSpace::SetMeridianEnds()
{
  double azimuth = 0;
  double sine = 0;
  const bool shifted = this->V.Stereo && this->V.EyeRadius == 0;
  if (shifted || !FindBorder(this->V, azimuth, sine))
  {
    return;
  }
  const double elevation = std::asin(std::min(1.0, sine)) + BorderMargin;
  this->MostSine = elevation < 0.5 * WFV_PI ? std::sin(elevation) : 2;
  azimuth += BorderMargin;
  this->MostAzimuth = azimuth;
  if (this->V.EyeRadius > 0)
  {
    return; // rays look aside of the direction from the middle
  }
  const vec3 right(std::cos(azimuth), 0, std::sin(azimuth));
  const vec3 left(-right.x, 0, right.z);
  if (azimuth < 0.5 * WFV_PI)
  {
    this->Planes = { right, left };
  }
  else if (azimuth < WFV_PI)
  {
    this->Wedge = { right, left };
  }
}

// True where an eye on a circle sees all of a triangle too high or too low. The level distance is
// convex, and the tangent to the circle is shorter.
bool RefineSpace::IsSteep(const vec3& p, const vec3& q, const vec3& r) const
{
  const vec3 up = wfvUpright(this->wfvView);
  double level2 = 0;
  double low = 1e300;
  double high = -1e300;
  for (const vec3* const c : { &p, &q, &r })
  {
    const double height = glm::dot(*c, up);
    low = std::min(low, height);
    high = std::max(high, height);
    const vec3 flat = *c - up * height;
    level2 = std::max(level2, glm::dot(flat, flat));
  }
  const double circle = this->wfvRefine.nearCircle;
  const double tangent = std::sqrt(std::max(0.0, level2 - circle * circle));
  const double steep = this->MostSine / std::sqrt(1 - this->MostSine * this->MostSine);
  return std::max(low, -high) > steep * tangent;
}

// True where an eye on a circle sees all of a triangle beyond the sides of the picture. It sees a
// place at the level distance d turned by the arc sine of the circle's radius over d.
bool RefineSpace::IsBesidePicture(const vec3& p, const vec3& q, const vec3& r) const
{
  const vec2 flat[3] = { vec2(p.x, -p.z), vec2(q.x, -q.z), vec2(r.x, -r.z) };
  const vec2 mean = flat[0] + flat[1] + flat[2];
  double nearest = 1e300;
  double farthest = 0;
  double longest = 0;
  double low = 0;
  double high = 0;
  for (int i = 0; i < 3; i++)
  {
    const double level = glm::length(flat[i]);
    nearest = std::min(nearest, level);
    farthest = std::max(farthest, level);
    longest = std::max(longest, glm::length(flat[(i + 1) % 3] - flat[i]));
    const double turn =
      std::atan2(flat[i].x * mean.y - flat[i].y * mean.x, glm::dot(flat[i], mean));
    low = std::min(low, turn);
    high = std::max(high, turn);
  }
  const double circle = this->V.EyeRadius;
  nearest = std::max(nearest - longest, circle);
  if (high - low > 0.5 * WFV_PI || !(farthest > circle))
  {
    return false;
  }
  const double side = wfvToRight(this->wfvView) < 0 ? -1 : 1;
  const double turns[2] = { side * std::asin(circle / nearest),
    side * std::asin(circle / farthest) };
  const double from = std::atan2(mean.x, mean.y) + low - std::max(turns[0], turns[1]);
  const double to = std::atan2(mean.x, mean.y) + high - std::min(turns[0], turns[1]);
  // behind is 0
  const double middle = std::remainder(0.5 * (from + to) - WFV_PI, 2 * WFV_PI);
  return std::abs(middle) + 0.5 * (to - from) < WFV_PI - this->MostAzimuth;
}

bool RefineSpace::IsEdgeOn(const vec3& p, const vec3& q, const vec3& r) const
{
  const bool central = this->V.EyeRadius == 0 && !(this->wfvRefine.depthBend > 0);
  return central &&
    std::abs(glm::dot(p, glm::cross(q, r))) <=
    EdgeOn * glm::length(p) * glm::length(q) * glm::length(r);
}

bool RefineSpace::IsOutside(const vec3& p, const vec3& q, const vec3& r) const
{
  const auto all = [&](const auto& outside) { return outside(p) && outside(q) && outside(r); };
  if (this->V.EyeRadius > 0 && this->V.Map->Axis == Family::Meridian)
  {
    return this->V.View.tilt.x == 1 &&
      ((this->MostSine < 1 && this->IsSteep(p, q, r)) ||
        (this->MostAzimuth < WFV_PI && this->IsBesidePicture(p, q, r)));
  }
  if (this->MostSine < 1)
  {
    // above the elevation, and below its opposite, is a convex cone
    const double sine = this->MostSine;
    if (all([sine](const vec3& c) { return c.y > sine * glm::length(c); }) ||
      all([sine](const vec3& c) { return -c.y > sine * glm::length(c); }))
    {
      return true;
    }
  }
  if (!this->Wedge.empty() && all([this](const vec3& c) {
        return glm::dot(this->Wedge[0], c) > 0 && glm::dot(this->Wedge[1], c) > 0;
      }))
  {
    return true;
  }
  const bool plane = std::any_of(this->Planes.begin(), this->Planes.end(),
    [&](const vec3& n) { return glm::dot(n, p) > 0 && glm::dot(n, q) > 0 && glm::dot(n, r) > 0; });
  if (plane || this->V.Map->Axis != Family::Azimuthal || this->V.View.maxAngle < 0.5 * WFV_PI)
  {
    return plane;
  }
  // what is beyond a rim of more than 90 degrees is convex
  const double cosine = std::cos(std::min(WFV_PI, this->V.View.maxAngle + PlaneMargin));
  const auto beyond = [cosine](const vec3& c) { return -c.z < cosine * glm::length(c); };
  return beyond(p) && beyond(q) && beyond(r);
}

vec2 RefineSpace::wfvPixelOf(const vec3& seen, double distance)
{
  vec2 ndc = this->V.Map->Project(seen / distance, this->wfvView);
  if (this->wfvRefine.depthBend > 0)
  {
    const double depth = 2 * wfvDepthOf(distance, this->wfvView) - 1;
    ndc = this->V.Stereo->Shift(ndc, std::clamp(depth, -1.0, 1.0), this->wfvView);
  }
  return 0.5 * this->V.Pixels * ndc;
}

// Whether a sphere round a place in the map's own frame may meet a discontinuity.
bool RefineSpace::SphereMayTear(const vec3& c, double radius) const
{
  const double distance = glm::length(c);
  const double farthest = distance + radius;
  const double beside = farthest * Beside + this->V.EyeRadius + radius;
  switch (this->V.Map->Axis)
  {
    case Family::Meridian:
      return std::abs(c.x) <= beside && c.z >= -beside;
    case Family::Planar:
      return c.z + beside > -2 * this->wfvRefine.beyondCosine * farthest;
    case Family::Faces:
      return !IsOnOneFace(c, c, c, 2 * beside);
    default:
    {
      // beyond the rim as well: what is not seen is not drawn
      const double cosine = std::cos(std::min(this->V.View.maxAngle, WFV_PI));
      return !(-c.z - beside > cosine * (cosine > 0 ? farthest : std::max(0.0, distance - radius)));
    }
  }
}

// Rays look aside of the direction from the middle, and see an edge under a larger angle than it
// does. The turning of the rays along the edge takes a part of the tolerance.
double RefineSpace::LimitOfCircle(const vec3& centre, double radius, double edge) const
{
  const ChordLimits& limits = *this->V.Limits;
  const double distance = glm::length(centre);
  const double nearest = distance - radius;
  const double height = glm::dot(centre, wfvUpright(this->wfvView));
  const double level =
    std::sqrt(std::max(0.0, glm::dot(centre, centre) - height * height)) - radius;
  const double r = this->V.EyeRadius;
  if (!(level > WFV_CIRCLE_FAR * r && level * level > 17 * edge * edge))
  {
    return 0;
  }
  const double off = r * edge * edge / (level * level) / nearest * this->wfvRefine.fade;
  const double stretch = limits.MostStretchAround(centre, radius / distance);
  const double left = 1 - off * stretch / this->V.Tolerance;
  const double larger = 1 + AsideSafety * r / level;
  const double sine = radius / distance + AsideSafety * r / nearest;
  return std::max(0.0, left) * limits.LeastAround(centre, sine) / (larger * larger);
}

double RefineSpace::LimitAround(const vec3& centre, double radius, double edge) const
{
  const double distance = glm::length(centre);
  const ChordLimits& limits = *this->V.Limits;
  if (limits.IsBesideSingularity(centre, radius / distance))
  {
    return 0;
  }
  if (this->V.EyeRadius > 0)
  {
    return this->LimitOfCircle(centre, radius, edge);
  }
  const double limit = limits.LeastAround(centre, radius / distance);
  if (!(this->wfvRefine.depthBend > 0))
  {
    return limit;
  }
  const double nearest = distance - radius;
  const double angle = edge / nearest;
  const double steep = edge / (this->V.View.radii.y - this->V.View.radii.x);
  const double bent = angle * steep + steep * steep;
  const double stretch = limits.MostStretchAround(centre, radius / distance);
  const vec2 half = 0.5 * this->V.Pixels;
  const double off = 0.25 * this->wfvRefine.depthBend *
    (bent * std::max(half.x, half.y) + 2 * angle * stretch * steep);
  return limit * std::max(0.0, 1 - off / this->V.Tolerance);
}

bool RefineSpace::IsCulled(Box box) const
{
  box.Grow(this->V.BaselineRadius);
  return this->V.Culls &&
    (this->AllAround ? !IsBetweenClips(this->V.View, box)
                     : wfv::IsCulled(*this->V.Map, this->V.View, box, this->V.Part));
}

bool RefineSpace::IsCulled(const vec3& p, const vec3& q, const vec3& r) const
{
  return this->IsCulled(Box{ glm::min(p, glm::min(q, r)), glm::max(p, glm::max(q, r)) });
}

Refiner::Need RefineSpace::OfCluster(const Box& box, double radius, double edge) const
{
  if (this->IsCulled(box))
  {
    return Refiner::Unseen;
  }
  const vec3 centre = 0.5 * (box.Low + box.High);
  const double distance = glm::length(centre);
  const double nearest = distance - radius - this->V.EyeRadius;
  const double farthest = distance + radius + this->V.EyeRadius;
  const double far = 0.5 * WFV_BEYOND * this->V.View.radii.y;
  if (!this->V.Limits || !(nearest > this->V.View.radii.x && farthest < far))
  {
    return this->V.Limits ? Refiner::Some : Refiner::Nothing;
  }
  const bool fine = edge * edge <= this->LimitAround(centre, radius, edge) * nearest * nearest &&
    !this->SphereMayTear(centre, radius);
  return fine ? Refiner::Nothing : Refiner::Some;
}

WfvEnd RefineSpace::wfvSeeEnd(const vec3& place) const
{
  WfvEnd e;
  e.place = place;
  e.reach = glm::length(place);
  e.limit = 0;
  e.seen = place;
  if (this->V.EyeRadius > 0)
  {
    const WfvRayHit hit = this->V.Stereo->See(place, this->wfvView);
    e.distance = hit.seen ? hit.distance : 0;
    e.seen = hit.direction * e.distance;
    return e;
  }
  e.distance = e.reach;
  if (this->wfvRefine.tears == WFV_TEARS_MERIDIAN && std::abs(place.x) < OnSeam * e.reach)
  {
    e.seen.x = 0; // all ends in the plane of the seam are on the same side of it
  }
  return e;
}

bool IsOnOneFace(const vec3& p, const vec3& q, const vec3& r, double beside)
{
  const vec3 a = glm::abs(p);
  const int axis = a.x >= a.y && a.x >= a.z ? 0 : a.y >= a.z ? 1 : 2;
  const double sign = p[axis] < 0 ? -1 : 1;
  bool one = true;
  for (const vec3* const c : { &p, &q, &r })
  {
    const double others = std::max(std::abs((*c)[(axis + 1) % 3]), std::abs((*c)[(axis + 2) % 3]));
    one = one && sign * (*c)[axis] > others + beside;
  }
  return one;
}

bool RefineSpace::IsWhole(const WfvEnd e[3]) const
{
  const double farthest = std::max({ e[0].distance, e[1].distance, e[2].distance });
  const double beside = Beside * farthest;
  switch (this->wfvRefine.tears)
  {
    case WFV_TEARS_MERIDIAN:
      return std::min({ e[0].seen.x, e[1].seen.x, e[2].seen.x }) > beside ||
        std::max({ e[0].seen.x, e[1].seen.x, e[2].seen.x }) < -beside ||
        std::max({ e[0].seen.z, e[1].seen.z, e[2].seen.z }) < -beside;
    case WFV_TEARS_PLANAR:
      return std::all_of(e, e + 3, [end = this->wfvRefine.beyondCosine](const WfvEnd& a) {
        return -a.seen.z > end * a.distance;
      });
    case WFV_TEARS_FACES:
      return IsOnOneFace(e[0].seen, e[1].seen, e[2].seen, 2 * beside);
    default:
    {
      const double cosine =
        this->wfvRefine.rimChord > 0 ? this->wfvRefine.rimCosine : std::cos(this->V.View.maxAngle);
      return std::all_of(
        e, e + 3, [cosine](const WfvEnd& a) { return -a.seen.z > cosine * a.distance; });
    }
  }
}
}
