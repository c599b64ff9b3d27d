// SPDX-License-Identifier: BSD-3-Clause
#include "FirstView.h"

#include "CameraSetup.h"
#include "Options/FilmOptions.h"
#include "Options/OptionCheck.h"
#include "Options/RoomOptions.h"
#include "Options/StereoChoice.h"
#include "Scenes/MeshBuilder.h"
#include "Scenes/Surroundings.h"
#include "System/Progress.h"
#include "Text/Angles.h"
#include "Text/Messages.h"

#include <algorithm>
#include <cmath>

namespace widefov
{
namespace
{
// How large the ball round a thing is seen: degrees. As a camera does that is not too near.
constexpr double UsualAngle = 50;

// Of a given field of view: the share that the ball fills, and the most, degrees. Nearer, what is
// in front hides the rest.
constexpr double Filled = 0.8;
constexpr double LargestAngle = 90;

// How far a thing reaches from the middle of the picture to its border, at most; with a bar of
// colours below.
constexpr double Reach = 0.9;
constexpr double ReachAboveBar = 0.73;

// A thing thinner than this share of its middle extent is looked at from where it is wide.
constexpr double Flat = 0.1;

// From the front, so many degrees to the right and above: three sides of a box are seen.
constexpr double ToTheRight = 30;
constexpr double Above = 25;
constexpr double AboveFlat = 50; // of what lies flat

// Degrees: nearer to straight down nobody knows where up is.
constexpr double Steepest = 85;

constexpr int MostPoints = 20000; // that are fitted into the picture
constexpr int FitSteps = 14;      // halvings: a field of view to a thousandth
constexpr int CenterSteps = 3;    // each leaves a small share of what is off the middle

// Coordinates of a place are round numbers, to this share of the scene's size: they can be typed.
constexpr double Round = 1e-3;

// Of globes of longitudes and latitudes.
const Vector3 NorthOfGlobe{ { 0, 0, 1 } };
const Vector3 GreenwichOfGlobe{ { 1, 0, 0 } };

// Right, up and back of a view, unit lengths.
struct Frame
{
  Vector3 Right;
  Vector3 Up;
  Vector3 Back;
};

// Of a view along `direction`; up is what is nearest to `up`.
Frame FrameOf(const Vector3& direction, const Vector3& up)
{
  Frame f;
  f.Back = -1 * Unit(direction);
  Vector3 right = Cross(up, f.Back);
  if (Dot(right, right) < 1e-12 * Dot(up, up))
  {
    right = Cross(UsualDirection(up), f.Back);
  }
  f.Right = Unit(right);
  f.Up = Cross(f.Back, f.Right);
  return f;
}

// Every so many of all points, and how far what is drawn reaches from the middle of the bounds.
struct Cloud
{
  std::vector<Vector3> Points;
  Vector3 Middle{ { 0, 0, 0 } };
  Vector3 Size{ { 0, 0, 0 } };
  double Radius = 0;
};

void AddPoints(const SceneProp& prop, vtkIdType stride, Cloud& cloud)
{
  for (vtkIdType i = 0; i < prop.Surface->GetNumberOfPoints(); i += stride)
  {
    Vector3 p;
    prop.Surface->GetPoint(i, p.data());
    const Vector3 arm = p - cloud.Middle;
    const double length = Length(arm);
    const double grown = length + prop.Margin;
    cloud.Points.push_back(cloud.Middle + (length > 0 ? grown / length : 0) * arm);
    cloud.Radius = std::max(cloud.Radius, grown);
  }
}

// The corners of what the scene becomes, where it is more than it is now.
void AddCorners(const vtkBoundingBox& all, Cloud& cloud)
{
  for (int i = 0; i < 8; i++)
  {
    Vector3 corner;
    all.GetCorner(i, corner.data());
    cloud.Points.push_back(corner);
    cloud.Radius = std::max(cloud.Radius, Length(corner - cloud.Middle));
  }
}

Cloud CloudOf(const Scene& scene, const vtkBoundingBox& later)
{
  Cloud cloud;
  double b[6];
  if (!SceneBounds(scene, b))
  {
    return cloud;
  }
  const vtkBoundingBox now(b);
  vtkBoundingBox all = now;
  all.AddBox(later);
  all.GetBounds(b);
  vtkIdType points = 0;
  for (const SceneProp& prop : scene.Props)
  {
    points += prop.Surface->GetNumberOfPoints();
  }
  for (std::size_t i = 0; i < 3; i++)
  {
    cloud.Middle[i] = 0.5 * (b[2 * i] + b[2 * i + 1]);
    cloud.Size[i] = b[2 * i + 1] - b[2 * i];
  }
  for (const SceneProp& prop : scene.Props)
  {
    AddPoints(prop, 1 + points / MostPoints, cloud);
  }
  if (all != now)
  {
    AddCorners(all, cloud);
  }
  return cloud;
}

// The axis along which a thing is flat, or -1.
int FlatAxis(const Vector3& size)
{
  Vector3 sorted = size;
  std::sort(sorted.begin(), sorted.end());
  if (sorted[0] > Flat * sorted[1])
  {
    return -1;
  }
  return static_cast<int>(std::min_element(size.begin(), size.end()) - size.begin());
}

// The direction to a thing that is seen from outside; from no more above than `most` degrees.
Vector3 DirectionTo(const Cloud& cloud, const Vector3& up, double most)
{
  const int flat = FlatAxis(cloud.Size);
  const Frame f = FrameOf(UsualDirection(up), up);
  if (flat >= 0)
  {
    Vector3 normal{ { 0, 0, 0 } };
    normal[static_cast<std::size_t>(flat)] = 1;
    if (std::abs(Dot(normal, f.Up)) < 0.5) // it stands: straight at it
    {
      return (Dot(normal, f.Back) + Dot(normal, f.Right) > 0 ? -1 : 1) * normal;
    }
  }
  const double elevation = std::min(flat >= 0 ? AboveFlat : Above, most) * Degree;
  const double azimuth = ToTheRight * Degree;
  return -1 *
    (std::sin(elevation) * f.Up +
      std::cos(elevation) * (std::sin(azimuth) * f.Right + std::cos(azimuth) * f.Back));
}

// How far beside the view's axis the middle of what is seen lies, at the distance of the cloud's.
Vector3 BesideAxis(const Cloud& cloud, const Frame& f, const Vector3& eye)
{
  const Vector3 to = cloud.Middle - eye;
  Vector3 low{ { HUGE_VAL, HUGE_VAL, 0 } };
  Vector3 high = -1 * low;
  for (const Vector3& p : cloud.Points)
  {
    const Vector3 arm = p - eye;
    const double depth = -Dot(arm, f.Back);
    const Vector3 seen{ { Dot(arm, f.Right) / depth, Dot(arm, f.Up) / depth, 0 } };
    for (std::size_t i = 0; i < 2; i++)
    {
      low[i] = std::min(low[i], seen[i]);
      high[i] = std::max(high[i], seen[i]);
    }
  }
  const double half = -0.5 * Dot(to, f.Back);
  return half * (low[0] + high[0]) * f.Right + half * (low[1] + high[1]) * f.Up;
}

// The place in front of the middle of what is seen that way.
Vector3 EyeBefore(const Cloud& cloud, const Frame& f, double angle)
{
  const double radius = cloud.Radius > 0 ? cloud.Radius : 1;
  Vector3 eye = cloud.Middle + radius / std::sin(0.5 * angle * Degree) * f.Back;
  for (int i = 0; i < CenterSteps && !cloud.Points.empty(); i++)
  {
    eye = eye + BesideAxis(cloud, f, eye);
  }
  return eye;
}

const wfv::Projection& ProjectionOf(const Options& o)
{
  return *wfv::FindProjection(o.Projection);
}

bool HasRoundMap(const Options& o)
{
  return ProjectionOf(o).Axis == wfv::Family::Azimuthal;
}

// The angle in which the ball round the thing is to be seen, degrees.
double AngleOf(const Options& o, bool fits)
{
  if (fits)
  {
    return UsualAngle;
  }
  const double field =
    HasRoundMap(o) ? o.View.HorizontalFov : std::min(o.View.HorizontalFov, o.View.VerticalFov);
  return std::min(Filled * field, o.View.Tilt == 0 ? LargestAngle : UsualAngle);
}

// How far above the direction of view a thing is to be that is seen in that angle, degrees: as low
// as all of it is shown, for there the audience of a dome looks, and no higher than the middle.
double Rise(const Options& o, double angle, double reach)
{
  const double half = 0.5 * (HasRoundMap(o) ? o.View.HorizontalFov : o.View.VerticalFov);
  const double tilt = o.View.Tilt;
  const double rise = std::max(0., std::abs(tilt) - reach * half + 0.5 * angle);
  return std::copysign(std::min(std::abs(tilt), rise), tilt);
}

// Towards up, about what is to the right.
Vector3 Raised(const Vector3& direction, const Vector3& up, double degrees)
{
  if (degrees == 0)
  {
    return direction;
  }
  const Frame f = FrameOf(direction, up);
  return std::sin(degrees * Degree) * f.Up - std::cos(degrees * Degree) * f.Back;
}

// Whether the field of view is free to be chosen. Of two eyes all round a player wants the sphere.
bool CanFit(const Options& o)
{
  const wfv::Projection& p = ProjectionOf(o);
  return !o.HasFov && o.LensFile.empty() && o.Circle.empty() && StereoOf(o).Traits.OneCenter &&
    o.View.Tilt == 0 && o.Technique != Technique::CubeMap && p.Axis != wfv::Family::Sampled &&
    p.MinHorizontalFov < p.MaxHorizontalFov;
}

bool Shows(const Options& o, const std::vector<wfv::vec3>& points, double reach)
{
  wfv::ViewOptions view = o.View;
  view.Stereo = wfv::StereoOptions();
  const wfv::View map(ProjectionOf(o), view);
  return std::all_of(points.begin(), points.end(), [&](const wfv::vec3& p) {
    const wfv::vec3 ndc = map.Forward(p).Ndc;
    return std::abs(ndc.x) < reach && std::abs(ndc.y) < reach &&
      map.Ray({ ndc.x / reach, ndc.y / reach }).Inside; // round maps have no corners
  });
}

// The smallest field of view that shows all; the one of the options where none does.
void Fit(Options& o, const Cloud& cloud, const Vector3& eye, const Frame& f, double reach)
{
  std::vector<wfv::vec3> points;
  for (const Vector3& p : cloud.Points)
  {
    const Vector3 arm = p - eye;
    points.emplace_back(Dot(arm, f.Right), Dot(arm, f.Up), Dot(arm, f.Back));
  }
  const wfv::Projection& p = ProjectionOf(o);
  double low = 0;
  double high = std::min(o.View.HorizontalFov, p.MaxHorizontalFov);
  Options best = o;
  for (int i = 0; i < FitSteps; i++)
  {
    Options tried = o;
    const double middle = 0.5 * (low + high);
    SetField(tried, middle);
    const bool valid = wfv::CheckOptions(p, tried.View).empty();
    const bool shows = valid && Shows(tried, points, reach);
    (shows ? high : low) = middle;
    best = shows ? tried : best;
  }
  o = best;
}

// Near the place.
Vector3 Rounded(Vector3 place, const Scene& scene)
{
  double b[6];
  if (SceneBounds(scene, b))
  {
    const double size = std::max({ b[1] - b[0], b[3] - b[2], b[5] - b[4] });
    const double step = std::pow(10, std::floor(std::log10(size > 0 ? Round * size : Round)));
    for (double& x : place)
    {
      x = std::round(x / step) * step + 0.; // no -0
    }
  }
  return place;
}

void StandOutside(Options& o, const Scene& scene, const vtkBoundingBox& later)
{
  const Cloud cloud = CloudOf(scene, later);
  const Vector3 up = o.Up.value_or(Vector3{ { 0, 1, 0 } });
  const bool fits = CanFit(o);
  const double reach = scene.BarMap && o.ScalarBarAt.empty() ? ReachAboveBar : Reach;
  const double angle = AngleOf(o, fits);
  const double rise = Rise(o, angle, reach);
  const Vector3 sight =
    o.Direction ? Raised(*o.Direction, up, rise) : DirectionTo(cloud, up, Steepest - rise);
  o.Direction = o.Direction.value_or(Raised(sight, up, -rise));
  const Frame f = FrameOf(sight, up);
  o.Eye = Rounded(EyeBefore(cloud, f, angle), scene);
  if (fits)
  {
    Fit(o, cloud, *o.Eye, f, reach);
  }
}

bool IsGlobe(const Scene& scene)
{
  return std::any_of(
    scene.Props.begin(), scene.Props.end(), [](const SceneProp& prop) { return prop.Globe; });
}

std::string Named(const Vector3& v)
{
  return Text(v[0]) + "," + Text(v[1]) + "," + Text(v[2]);
}

void SayWhereTheEyeIs(const Vector3& eye, bool inside)
{
  Say(inside ? "the eye is inside, at " + Named(eye) +
        ", for the data are all round it; --outside shows them from outside"
             : "the eye is outside, at " + Named(eye) +
        ", for the data are a thing to look at; --inside puts it into their middle");
}
}

void ChooseView(Options& o, const Scene& scene, const vtkBoundingBox& later)
{
  const bool asked = o.Inside || o.Outside;
  if (scene.Props.empty() || o.Eye || (!asked && (o.LookAt || HasRoom(o) || !o.Scene.empty())))
  {
    return;
  }
  if (SaysWhereTheEyeGoes(o.Film))
  {
    if (IsGlobe(scene) && !o.Up)
    {
      o.Up = NorthOfGlobe;
    }
    return;
  }
  const Progress progress("finding where the eye is to be");
  std::optional<Vector3> inside = o.Outside ? std::nullopt : SurroundedPlace(scene);
  if (o.Inside && !inside)
  {
    inside = FreePlace(scene);
  }
  if (IsGlobe(scene) && !o.Up && !o.Direction && !o.LookAt)
  {
    o.Up = NorthOfGlobe;
    o.Direction = inside ? std::optional(GreenwichOfGlobe) : std::nullopt;
  }
  if (inside)
  {
    o.Eye = Rounded(*inside, scene);
  }
  else
  {
    StandOutside(o, scene, later);
  }
  if (!asked && !o.DryRun) // which prints the view itself
  {
    SayWhereTheEyeIs(*o.Eye, inside.has_value());
  }
}
}
