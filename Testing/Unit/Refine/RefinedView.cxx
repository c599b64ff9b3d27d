// SPDX-License-Identifier: BSD-3-Clause
#include "Refine/RefinedView.h"

#include "Stereo/Stereo.h"
#include "Views.h"

#include <algorithm>
#include <cmath>

namespace wfv
{
namespace test
{
namespace
{
const vec2 Pixels(1024, 512);
constexpr int TrianglesOfCluster = 30;

// As common/beside.glsl.
constexpr double AsideOfDistance = 1e-6;

vec3 Beside(const vec3& p, Family family, float aside)
{
  const double rho = glm::length(p);
  if (aside == 0 || rho == 0)
  {
    return p;
  }
  if (family == Family::Meridian)
  {
    const double side = std::clamp(aside, -1.0f, 1.0f);
    return vec3(side * std::max(side * p.x, AsideOfDistance * rho), p.y, p.z);
  }
  const int axis = (static_cast<int>(aside) - 1) / 2;
  const double most = (1 - AsideOfDistance) * std::abs(p[axis]);
  vec3 inside = glm::clamp(p, vec3(-most), vec3(most));
  inside[axis] = p[axis];
  return inside;
}

ViewOptions OptionsOf(const Projection& p, double part)
{
  ViewOptions o;
  o.HorizontalFov = std::max(p.MinHorizontalFov, part * p.MaxHorizontalFov);
  o.VerticalFov = std::max(p.MinVerticalFov, part * p.MaxVerticalFov);
  o.Radii = { { 0.1, 50 } };
  return o;
}

std::string NameOf(const Projection& p, const ViewOptions& o, double tolerance)
{
  const std::string eye = !o.Stereo.Model
    ? ""
    : ", " + o.Stereo.Model->Name + (o.Stereo.Eye == Eye::Left ? " left" : " right") +
      (o.Stereo.PoleFade[1] > o.Stereo.PoleFade[0] ? " fading" : "");
  return MakeView(p, o).Name + eye + ", tolerance " + std::to_string(tolerance);
}
}

RefinedView::RefinedView(const Projection& p, const ViewOptions& o, double tolerance)
  : Name(NameOf(p, o, tolerance))
  , TheView(p, o)
{
  const WfvView& v = this->TheView.GetParameters();
  const StereoModel* const model = this->TheView.GetStereoModel();
  this->V.Map = &this->TheView.GetProjection();
  this->V.View = v;
  this->V.Tolerance = tolerance;
  this->V.Pixels = Pixels;
  this->V.Stereo = model;
  this->V.EyeRadius = model && !model->Traits.OneCenter ? wfvFromMiddle(v) : 0;
  this->V.BaselineRadius = this->V.EyeRadius;
  this->V.Limits = std::make_shared<ChordLimits>(p, v, LocalCurvature(p, v), Pixels, tolerance);
  this->R.reset(new Refiner(this->V));
}

vec3 RefinedView::See(const vec3& place) const
{
  if (!this->V.Stereo)
  {
    return place;
  }
  const WfvRayHit hit = this->V.Stereo->See(place, this->V.View);
  return hit.seen ? hit.direction * hit.distance : vec3(0);
}

vec2 RefinedView::At(const vec3& place, float aside) const
{
  const vec3 seen = this->See(place);
  const double rho = glm::length(seen);
  vec2 ndc =
    this->V.Map->Project(glm::normalize(Beside(seen, this->V.Map->Axis, aside)), this->V.View);
  if (this->V.Stereo)
  {
    const double depth = 2 * wfvDepthOf(rho, this->V.View) - 1;
    ndc = this->V.Stereo->Shift(ndc, std::clamp(depth, -1.0, 1.0), this->V.View);
  }
  return 0.5 * Pixels * ndc;
}

double RefinedView::TurnOf(const vec2& pixel, const vec3& place) const
{
  const vec3 shown = this->V.Map->Unproject(2.0 * pixel / Pixels, this->V.View).direction;
  const double cosine = glm::dot(shown, glm::normalize(this->See(place)));
  return std::acos(std::clamp(cosine, -1.0, 1.0)) * Pixels.x / (2 * this->V.View.halfFov.x);
}

bool RefinedView::IsSeen(const vec3& place) const
{
  return this->TheView.Forward(place).Inside;
}

double RefinedView::PixelsFromTear(const vec3& place) const
{
  const vec3 seen = this->See(place);
  if (glm::length(seen) == 0)
  {
    return 0; // no ray of the eye meets it
  }
  const vec3 d = glm::normalize(seen);
  const double fromAxis = std::acos(std::clamp(-d.z, -1.0, 1.0));
  const vec3 a = glm::abs(d);
  const double most = std::max({ a.x, a.y, a.z });
  const double second = a.x + a.y + a.z - most - std::min({ a.x, a.y, a.z });
  double angle = most - second; // of maps of faces
  switch (this->V.Map->Axis)
  {
    case Family::Meridian:
      angle = d.z > 0 ? a.x : std::hypot(d.x, d.z);
      break;
    case Family::Azimuthal:
      angle = std::min(std::abs(this->V.View.maxAngle - fromAxis), WFV_PI - fromAxis);
      break;
    case Family::Planar:
      angle = 1;
      break;
    default:
      break;
  }
  if (this->V.EyeRadius > 0)
  {
    angle = std::min(angle, std::hypot(d.x, d.z)); // the axis of the circle of the eyes
  }
  return angle * Pixels.x / (2 * this->V.View.halfFov.x);
}

double RefinedView::GetTornPixels() const
{
  // pieces end beside the circle of the eyes, nearer to the pole than the middle of any pixel
  const double pole = this->V.EyeRadius > 0 ? 0.5 : 0;
  // the rim or the antipode of a round map is cut along chords
  const double rim = this->V.Map->Axis == Family::Azimuthal ? 1.25 : 0.25;
  return std::max(rim * this->V.Tolerance, pole);
}

namespace
{
// Skirts reach across a curved border: they are no part of a triangle.
void RemoveSkirts(Pieces& pieces)
{
  std::vector<unsigned int> kept;
  for (std::size_t i = 0; i < pieces.Indices.size(); i += 3)
  {
    const auto first = pieces.Indices.begin() + static_cast<std::ptrdiff_t>(i);
    if (std::none_of(first, first + 3,
          [&](unsigned int v) { return std::abs(pieces.Vertices[v].Aside) == 2; }))
    {
      kept.insert(kept.end(), first, first + 3);
    }
  }
  pieces.Numbers.resize(kept.size() / 3);
  pieces.Indices.swap(kept);
}
}

Pieces RefinedView::Refine(const Triangle& t) const
{
  Pieces pieces;
  if (this->R->Take(t[0], t[1], t[2], 0, pieces))
  {
    for (int i = 0; i < 3; i++)
    {
      PieceVertex vertex;
      vertex.Weights = { double(i == 0), double(i == 1), double(i == 2) };
      pieces.Vertices.push_back(vertex);
      pieces.Indices.push_back(i);
    }
    pieces.Sources.assign(3, 0);
    pieces.Numbers.assign(1, 0);
  }
  if (this->V.Map->Axis != Family::Faces)
  {
    RemoveSkirts(pieces);
  }
  return pieces;
}

bool RefinedView::IsFine(const Triangle& t) const
{
  Pieces pieces;
  return this->R->Take(t[0], t[1], t[2], 0, pieces);
}

vec3 PlaceOf(const Triangle& t, const PieceVertex& vertex)
{
  const std::array<double, 3>& w = vertex.Weights;
  for (int i = 0; i < 3; i++)
  {
    const int j = (i + 1) % 3;
    const int k = (i + 2) % 3;
    if (w[i] == 1)
    {
      return t[i];
    }
    if (w[k] == 0 && w[i] != 0 && w[j] != 0)
    {
      return w[i] * t[i] + w[j] * t[j];
    }
  }
  return w[0] * t[0] + w[1] * t[1] + w[2] * t[2];
}

vec3 Shapes::Weights()
{
  const double first = std::abs(this->Unit());
  const double second = std::abs(this->Unit()) * (1 - first);
  return vec3(1 - first - second, first, second);
}

vec3 Shapes::Direction(int number)
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

double Shapes::Distance()
{
  return std::pow(10, 2 * this->Unit());
}

// size: over the distance; width: over the size.
Triangle Shapes::MakeAt(const vec3& at, double distance, double size, double width)
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

Triangle Shapes::Make(int number)
{
  const double size = std::pow(10, -1 + 1.6 * this->Unit());
  const double width = number % 3 ? std::pow(10, -1 + this->Unit()) : 1;
  return this->MakeAt(this->Direction(number), this->Distance(), size, width);
}

std::vector<Triangle> Shapes::MakeCluster(int number)
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

std::vector<std::unique_ptr<RefinedView>> MonoViews(const Projection& p)
{
  std::vector<std::unique_ptr<RefinedView>> views;
  for (const double part : { 0.3, 1.0 })
  {
    for (const double tolerance : { 0.25, 1.0 })
    {
      views.emplace_back(new RefinedView(p, OptionsOf(p, part), tolerance));
    }
  }
  return views;
}

std::vector<std::unique_ptr<RefinedView>> StereoViews(const Projection& p)
{
  std::vector<std::unique_ptr<RefinedView>> views;
  for (int i = 0; i < 6 && p.Axis != Family::Planar; i++)
  {
    ViewOptions o = OptionsOf(p, 1);
    o.Stereo.Model = FindStereoModel(i < 4 ? "omnidirectional" : "warped");
    o.Stereo.InterpupillaryDistance = 0.065;
    o.Stereo.Eye = i % 2 == 0 ? Eye::Left : Eye::Right;
    if (i == 2 || i == 3)
    {
      o.Stereo.PoleFade = { { 50, 80 } };
    }
    views.emplace_back(new RefinedView(p, o, 0.25));
  }
  return views;
}

std::vector<std::string> NamesOfFamilies()
{
  return { "equirectangular", "hammer", "azimuthal-equidistant", "equi-angular-cubemap",
    "perspective" };
}

std::vector<std::string> NamesOfOthers()
{
  const std::vector<std::string> families = NamesOfFamilies();
  std::vector<std::string> names;
  for (const Projection& p : Projections())
  {
    if (std::find(families.begin(), families.end(), p.Name) == families.end())
    {
      names.push_back(p.Name);
    }
  }
  return names;
}

std::string NameOfProjection(const std::string& name)
{
  std::string text = name;
  std::replace(text.begin(), text.end(), '-', '_');
  return text;
}
}
}
