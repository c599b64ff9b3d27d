// SPDX-License-Identifier: BSD-3-Clause
// By rays, not by a frame: so it is known before there is a window.
#include "EyeDistance.h"

#include "CameraSetup.h"
#include "Options/StereoChoice.h"
#include "Scenes/MeshBuilder.h"
#include "Stereo/Comfort.h"
#include "Stereo/Stereo.h"
#include "System/Progress.h"
#include "Text/Messages.h"

#include <vtkAbstractCellLocator.h>
#include <vtkNew.h>
#include <vtkStaticCellLocator.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numeric>

namespace widefov
{
namespace
{
// Rays over the picture: what none of them meets is too small to decide anything.
constexpr int Columns = 96;
constexpr int Rows = 48;

// Of the rays, at either end of their distances: a leaf before the lens decides nothing.
constexpr double LeftOut = 0.01;

constexpr double Infinity = std::numeric_limits<double>::infinity();

// Of the latitude of what counts as level.
constexpr double LevelSine = 0.7;

// Times the distance to the far corner of the scene: every ray ends outside.
constexpr double Beyond = 2;

std::string Rounded(double value)
{
  char text[64];
  std::snprintf(text, sizeof(text), "%.3g", value);
  return text;
}

using wfv::vec2;
using wfv::vec3;

// What lies ahead of one eye in the middle.
wfv::View MiddleView(const Options& o, wfv::Eye eye = wfv::Eye::Middle)
{
  wfv::ViewOptions v = o.View;
  v.Stereo.Eye = eye;
  v.Stereo.Model = eye == wfv::Eye::Middle ? nullptr : v.Stereo.Model;
  return { *wfv::FindProjection(o.Projection), v };
}

// NDC of the middle of each patch of the picture that the map has a direction for.
std::vector<vec2> Places(const wfv::View& view)
{
  std::vector<vec2> places;
  for (int i = 0; i < Columns * Rows; i++)
  {
    const vec2 ndc((2 * (i % Columns) + 1.) / Columns - 1, (2 * (i / Columns) + 1.) / Rows - 1);
    if (view.Ray(ndc).Inside)
    {
      places.push_back(ndc);
    }
  }
  return places;
}

double FarCorner(const Scene& scene, const Vector3& eye)
{
  double b[6] = {};
  SceneBounds(scene, b);
  double sum = 0;
  for (int i = 0; i < 3; i++)
  {
    const double side = std::max(std::abs(b[2 * i] - eye[i]), std::abs(b[2 * i + 1] - eye[i]));
    sum += side * side;
  }
  return std::sqrt(sum);
}

// Shortens each ray to where it meets the surface; `reach`: the longest that there can be.
void Meet(vtkAbstractCellLocator* cells, const Pose& pose, const std::vector<vec3>& rays,
  double reach, std::vector<double>& lengths)
{
  for (std::size_t i = 0; i < rays.size(); i++)
  {
    const double length = std::min(lengths[i], reach);
    const Vector3 end = pose.Eye + length * ToWorld(pose, rays[i]);
    double t = 1;
    double point[3];
    double coordinates[3];
    int part = 0;
    if (cells->IntersectWithLine(pose.Eye.data(), end.data(), 0, t, point, coordinates, part))
    {
      lengths[i] = t * length;
    }
  }
}

double Along(const Vector3& v, const Vector3& axis)
{
  return std::inner_product(v.begin(), v.end(), axis.begin(), 0.);
}

bool Shows(const wfv::View& view, const Pose& pose, const Vector3& point)
{
  const Vector3 from = point - pose.Eye;
  const Vector3 right = Unit(Cross(pose.Direction, pose.Up));
  const vec3 p(
    Along(from, right), Along(from, Cross(right, pose.Direction)), -Along(from, pose.Direction));
  const vec3 ndc = view.Forward(p).Ndc;
  return std::abs(ndc.x) <= 1 && std::abs(ndc.y) <= 1 && view.Ray(vec2(ndc.x, ndc.y)).Inside;
}

// Of what no ray may meet: lines, points and what is drawn round them, surfaces far away. Infinite
// where it is not in the picture.
double Closest(
  vtkAbstractCellLocator* cells, const SceneProp& prop, const wfv::View& view, const Pose& pose)
{
  Vector3 point;
  vtkIdType cell = 0;
  int part = 0;
  double squared = 0;
  cells->FindClosestPoint(pose.Eye.data(), point.data(), cell, part, squared);
  return Shows(view, pose, point) ? std::max(0., std::sqrt(squared) - prop.Margin) : Infinity;
}

// What the picture shows of each kind of thing.
struct Sample
{
  std::vector<double> Lengths; // of rays that end at a surface
  double Thing = Infinity;     // the nearest that is no surface
  double Surface = Infinity;   // the nearest point of one, where rays go past it
};

Sample TakeSample(const Scene& scene, const wfv::View& view, const Pose& pose)
{
  Sample sample;
  std::vector<vec3> rays;
  for (const vec2& ndc : Places(view))
  {
    rays.push_back(view.Ray(ndc).Direction);
  }
  sample.Lengths.assign(rays.size(), Infinity);
  const double reach = Beyond * FarCorner(scene, pose.Eye);
  for (const SceneProp& prop : scene.Props)
  {
    if (!prop.Surface || prop.Surface->GetNumberOfCells() == 0)
    {
      continue;
    }
    vtkNew<vtkStaticCellLocator> cells;
    cells->SetDataSet(prop.Surface);
    cells->BuildLocator();
    const bool solid = prop.Surface->GetNumberOfPolys() + prop.Surface->GetNumberOfStrips() > 0;
    double& nearest = solid ? sample.Surface : sample.Thing;
    nearest = std::min(nearest, Closest(cells, prop, view, pose));
    if (solid)
    {
      Meet(cells, pose, rays, reach, sample.Lengths);
    }
  }
  for (std::size_t i = 0; view.GetProjection().Axis == wfv::Family::Planar && i < rays.size(); i++)
  {
    sample.Lengths[i] *= -rays[i].z; // how far ahead it is, which flat pictures go by
  }
  return sample;
}

// Distances of the nearest and the farthest thing seen, infinite where there is nothing.
std::array<double, 2> SeenRange(const Options& o, const Scene& scene)
{
  Sample sample = TakeSample(scene, MiddleView(o), MakePose(scene, o));
  std::vector<double>& lengths = sample.Lengths;
  lengths.erase(std::remove(lengths.begin(), lengths.end(), Infinity), lengths.end());
  if (lengths.empty())
  {
    const double nearest = std::min(sample.Thing, sample.Surface);
    return { { nearest, nearest } };
  }
  return { { std::min(sample.Thing, wfv::Quantile(lengths, LeftOut)),
    wfv::Quantile(lengths, 1 - LeftOut) } };
}

struct Disparity
{
  double Pixels = 0;
  double Degrees = 0;
};

// Returns a point in the view coordinates of an eye, which turns about the vertical.
vec3 Turned(const vec3& p, wfv::StereoOptions stereo, wfv::Eye eye)
{
  stereo.Eye = eye;
  const double turn = wfv::EyeTurn(stereo);
  const double c = std::cos(turn);
  const double s = std::sin(turn);
  return { c * p.x - s * p.z, p.y, s * p.x + c * p.z };
}

// Of eyes on a circle: the largest in the picture, of something at this distance. Towards the poles
// maps stretch it: pixels count where the picture is level, if it is anywhere.
Disparity RoundDisparity(const Options& o, double distance)
{
  const wfv::View middle = MiddleView(o);
  const wfv::View eyes[] = { MiddleView(o, wfv::Eye::Left), MiddleView(o, wfv::Eye::Right) };
  Disparity largest;
  double steep = 0;
  for (const vec2& ndc : Places(middle))
  {
    const vec3 direction = middle.Ray(ndc).Direction;
    const vec3 point = direction * distance;
    const vec3 left = eyes[0].Forward(Turned(point, o.View.Stereo, wfv::Eye::Left)).Ndc;
    const vec3 right = eyes[1].Forward(Turned(point, o.View.Stereo, wfv::Eye::Right)).Ndc;
    const wfv::ViewRay a = middle.Ray(vec2(left.x, left.y));
    const wfv::ViewRay b = middle.Ray(vec2(right.x, right.y));
    if (a.Inside && b.Inside && std::abs(left.x - right.x) < 1) // the seam is not between them
    {
      double& pixels = std::abs(direction.y) < LevelSine ? largest.Pixels : steep;
      pixels = std::max(pixels,
        std::hypot(0.5 * o.Size[0] * (left.x - right.x), 0.5 * o.Size[1] * (left.y - right.y)));
      const double cosine = std::clamp(glm::dot(a.Direction, b.Direction), -1., 1.);
      largest.Degrees = std::max(largest.Degrees, glm::degrees(std::acos(cosine)));
    }
  }
  largest.Pixels = largest.Pixels > 0 ? largest.Pixels : steep;
  return largest;
}

// Of eyes before a flat picture, seen from where the perspective is right.
Disparity FlatDisparity(const Options& o, double distance)
{
  const wfv::StereoOptions& s = o.View.Stereo;
  const double percent = std::abs(wfv::Parallax(s.Separation, s.Convergence, distance));
  const double width = 2 * std::tan(0.5 * glm::radians(o.View.HorizontalFov));
  return { 0.01 * percent * o.Size[0], wfv::ParallaxAngle(percent, width, 1) };
}

Disparity DisparityAt(const Options& o, double distance)
{
  return StereoOf(o).Traits.Flat ? FlatDisparity(o, distance) : RoundDisparity(o, distance);
}

// What to do about it.
std::string Remedy(const Options& o, double nearest)
{
  using Number = wfv::StereoNumber;
  return StereoOf(o).Has(Number::InterpupillaryDistance)
    ? "--ipd auto, which is " + Rounded(wfv::ComfortableEyeDistance(nearest)) + " here"
    : "another --separation, or --convergence auto";
}

void Judge(const Options& o, const std::array<double, 2>& seen)
{
  const double ipd = o.View.Stereo.InterpupillaryDistance;
  if (StereoOf(o).Has(wfv::StereoNumber::InterpupillaryDistance) && ipd > seen[0])
  {
    Say("warning: --ipd " + Text(ipd) + " is larger than the distance of the nearest thing seen, " +
      Rounded(seen[0]) + ": what is inside the circle of the eyes is not shown; give " +
      Remedy(o, seen[0]));
    return;
  }
  const Disparity near = DisparityAt(o, seen[0]);
  const Disparity far = DisparityAt(o, seen[1]);
  const double degrees = std::max(near.Degrees, far.Degrees);
  const double pixels = std::max(near.Pixels, far.Pixels);
  const std::string what = "warning: what the eyes see of things at distances from " +
    Rounded(seen[0]) + " to " + Rounded(seen[1]) + " is up to ";
  if (degrees > wfv::LargestDisparity())
  {
    Say(what + Rounded(degrees) + " degrees apart, and more than " +
      Rounded(wfv::LargestDisparity()) + " is uncomfortable; give " + Remedy(o, seen[0]));
  }
  else if (pixels < 1)
  {
    Say(what + Rounded(pixels) + " pixels apart, and under one nobody sees depth; give " +
      Remedy(o, seen[0]));
  }
}
}

void FitEyes(Options& o, const Scene& scene)
{
  // of lines that are not straight the numbers are those of the picture, not of the scene
  if (!HasTwoEyes(o) || ShowsCube(o) || !o.Screens.empty())
  {
    return;
  }
  const Progress progress("looking for the nearest thing");
  const std::array<double, 2> seen = SeenRange(o, scene);
  if (seen[0] == Infinity || seen[0] == 0)
  {
    if (o.EyesByDepth)
    {
      Say("warning: nothing is seen at a distance that the eyes could be fitted to; --ipd " +
        Text(o.View.Stereo.InterpupillaryDistance) + " is kept");
    }
    return;
  }
  if (o.EyesByDepth)
  {
    o.View.Stereo.InterpupillaryDistance = wfv::ComfortableEyeDistance(seen[0]);
    Tell("--ipd auto is " + Text(o.View.Stereo.InterpupillaryDistance) +
      ": the nearest thing seen is " + Rounded(seen[0]) + " away");
    return;
  }
  if (!o.ConvergeOnDepth)
  {
    Judge(o, seen);
  }
}
}
