// SPDX-License-Identifier: BSD-3-Clause
// The projection files in float32 on the GPU against the same files in double.
#include "GpuEvaluator.h"
#include "Views.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <random>

using namespace wfv;
using namespace wfv::test;

namespace
{
// Largest distance between the two, in pixels of a picture 8192 wide.
constexpr double Agreement = 0.02;
constexpr double PictureWidth = 8192;

// Of depth, which runs from 0 to 1: a few steps of float32.
constexpr double DepthAgreement = 3e-7;

// float32 places within this of the border of the map may fall on either side: four steps.
constexpr double BorderSlack = 4 * 1.2e-7;

using Texel = GpuEvaluator::Texel;
constexpr int Count = GpuEvaluator::Side * GpuEvaluator::Side;

Texel ToTexel(const vec3& v)
{
  return { { float(v.x), float(v.y), float(v.z), 0 } };
}

// Half of them uniform on the sphere, half at distances from 1e-7 to 1 radian, evenly in
// the logarithm, from the poles, the axis, the antipode and the seam.
std::vector<Texel> Directions()
{
  std::mt19937_64 engine(5);
  std::uniform_real_distribution<double> unit(-1, 1);
  std::vector<Texel> texels;
  for (const vec3& d : RandomDirections(Count / 2))
  {
    texels.push_back(ToTexel(d));
  }
  while (int(texels.size()) < Count)
  {
    const double around = WFV_PI * unit(engine);
    const double distance = std::pow(10, -3.5 + 3.5 * unit(engine));
    const vec3 towardsZ = wfvAzimuthalDirection(vec2(around, distance));
    const vec3 towardsY(towardsZ.x, -towardsZ.z, towardsZ.y);
    const double side = unit(engine) < 0 ? -1 : 1;
    switch (texels.size() % 3)
    {
      case 0:
        texels.push_back(ToTexel(towardsZ * side));
        break;
      case 1:
        texels.push_back(ToTexel(towardsY * side));
        break;
      default:
        texels.push_back(
          ToTexel(wfvMeridianDirection(vec2(side * (WFV_PI - distance), 0.5 * around))));
    }
  }
  return texels;
}

// Half of them uniform in the window, half at distances from 1e-7 to 1 from its borders.
std::vector<Texel> Points()
{
  std::mt19937_64 engine(6);
  std::uniform_real_distribution<double> unit(-1, 1);
  std::vector<Texel> texels;
  for (int i = 0; i < Count; ++i)
  {
    double x = unit(engine);
    double y = unit(engine);
    if (i % 2)
    {
      const double r = 1 - std::pow(10, -3.5 + 3.5 * unit(engine));
      const double length = i % 4 == 1 ? std::max(std::abs(x), std::abs(y)) : std::hypot(x, y);
      x *= r / length;
      y *= r / length;
    }
    texels.push_back({ { float(x), float(y), 0, 0 } });
  }
  return texels;
}

struct Worst
{
  double Pixels = 0;
  std::string Case;
  long Inputs = 0;
  void Add(double pixels, const std::string& text)
  {
    this->Pixels = pixels;
    this->Case = text;
  }
};

vec3 ToVec3(const Texel& t)
{
  return vec3(t[0], t[1], t[2]);
}

// wfvProject: the distance in the picture.
Worst WorstForward(const NamedView& v, const std::vector<Texel>& in, const std::vector<Texel>& out)
{
  Worst worst;
  const Projection& p = v.TheView.GetProjection();
  const double height = PictureWidth / v.Options.Aspect;
  for (int i = 0; i < Count; ++i)
  {
    const vec3 d = ToVec3(in[i]);
    if (!InDomain(v.TheView, d))
    {
      continue;
    }
    const vec2 cpu = p.Project(d, v.TheView.GetParameters());
    if (std::abs(cpu.x) > 1 || std::abs(cpu.y) > 1)
    {
      continue; // outside the picture
    }
    ++worst.Inputs;
    const double error =
      std::hypot(0.5 * PictureWidth * (out[i][0] - cpu.x), 0.5 * height * (out[i][1] - cpu.y));
    if (!(error <= worst.Pixels))
    {
      worst.Add(error,
        v.Name + "\n  direction " + Text(d) + "\n  double " + Text(cpu) + "\n  float  " +
          Text(vec2(out[i][0], out[i][1])));
    }
  }
  return worst;
}

bool IsOnBorder(const View& view, const vec2& ndc)
{
  return view.Ray(ndc * (1 - BorderSlack)).Inside != view.Ray(ndc * (1 + BorderSlack)).Inside;
}

// Whether a ray that looks back, of a map that ends behind the eye, is not on the border nor beyond
// it: there it would see what the other border shows.
bool IsOnItsSide(const Projection& p, const vec3& d, const vec2& ndc)
{
  const bool back = p.Axis == Family::Meridian && d.z > 0;
  return !back || ndc.x == 0 || d.x * ndc.x > 0;
}

// wfvUnproject: the angle between the directions, by the pixels an angle has on the axis,
// or how far from its point in the picture the direction found really lies: where a map is
// flat (at the poles of an equal-area cylinder) the one says nothing, where it stretches (at
// those of the equirectangular one) the other.
Worst WorstRay(const NamedView& v, const std::vector<Texel>& in, const std::vector<Texel>& out)
{
  Worst worst;
  const Projection& p = v.TheView.GetProjection();
  const double pixelsPerRadian = 0.5 * PictureWidth / v.TheView.GetParameters().halfFov.x;
  for (int i = 0; i < Count; ++i)
  {
    const vec2 ndc(in[i][0], in[i][1]);
    const WfvRay cpu = p.Unproject(ndc, v.TheView.GetParameters());
    const bool gpuInside = out[i][3] > 0.5f;
    EXPECT_TRUE(gpuInside == cpu.inside || IsOnBorder(v.TheView, ndc))
      << v.Name << " ndc " << Text(ndc);
    if (!cpu.inside || !gpuInside)
    {
      continue;
    }
    ++worst.Inputs;
    EXPECT_TRUE(IsOnItsSide(p, ToVec3(out[i]), ndc))
      << v.Name << " ndc " << Text(ndc) << " ray " << Text(ToVec3(out[i]));
    const vec2 place = p.Project(ToVec3(out[i]), v.TheView.GetParameters());
    const double height = PictureWidth / v.Options.Aspect;
    const double aside =
      std::hypot(0.5 * PictureWidth * (place.x - ndc.x), 0.5 * height * (place.y - ndc.y));
    const double angle = pixelsPerRadian * glm::length(ToVec3(out[i]) - cpu.direction);
    const double error = aside < angle ? aside : angle;
    if (!(error <= worst.Pixels))
    {
      worst.Add(error,
        v.Name + "\n  ndc " + Text(ndc) + "\n  double " + Text(cpu.direction) + "\n  float  " +
          Text(ToVec3(out[i])));
    }
  }
  return worst;
}

std::vector<NamedView> Views()
{
  std::vector<NamedView> views;
  for (const Projection& p : Projections())
  {
    for (double fov : { 60.0, 170.0, p.MaxHorizontalFov })
    {
      if (fov < p.MinHorizontalFov || fov > p.MaxHorizontalFov)
      {
        continue;
      }
      ViewOptions o;
      o.HorizontalFov = fov;
      o.VerticalFov = std::clamp(fov / 2, p.MinVerticalFov, p.MaxVerticalFov);
      o.Aspect = p.Axis == Family::Azimuthal ? 1 : 2;
      views.push_back(MakeView(p, o));
      for (const auto& lens : Lenses(p, fov))
      {
        o.Lens = lens;
        views.push_back(MakeView(p, o));
      }
    }
  }
  return views;
}
}

TEST(GpuMath, AgreesWithDouble)
{
  GpuEvaluator gpu;
  std::cout << gpu.GetRenderer() << "\n";
  const std::vector<Texel> directions = Directions();
  const std::vector<Texel> points = Points();
  for (const NamedView& v : Views())
  {
    std::vector<Texel> projected;
    std::vector<Texel> unprojected;
    ASSERT_TRUE(gpu.Evaluate(v.TheView, directions, points, projected, unprojected)) << v.Name;
    const Worst forward = WorstForward(v, directions, projected);
    const Worst ray = WorstRay(v, points, unprojected);
    std::cout << v.Name << ": project " << forward.Pixels << " px of " << forward.Inputs
              << ", unproject " << ray.Pixels << " px of " << ray.Inputs << "\n";
    EXPECT_GT(forward.Inputs, Count / 100) << v.Name;
    // the sinusoidal map fills 2 / pi of its rectangle, and hardly reaches its corners
    EXPECT_GT(ray.Inputs, Count / 3) << v.Name;
    EXPECT_LE(forward.Pixels, Agreement) << forward.Case;
    EXPECT_LE(ray.Pixels, Agreement) << ray.Case;
  }
}

// Depth of float32 distances, evenly in the logarithm between the spheres.
TEST(GpuMath, DepthAgreesWithDouble)
{
  GpuEvaluator gpu;
  const double near = 1e-4;
  const double far = 1;
  std::vector<Texel> distances(Count, Texel{ { 0, 0, -1, 0 } });
  for (int i = 0; i < Count; ++i)
  {
    distances[i][3] = float(near * std::pow(far / near, (i + 0.5) / Count));
  }
  for (DepthMapping mapping :
    { DepthMapping::Linear, DepthMapping::Logarithmic, DepthMapping::Reversed })
  {
    ViewOptions o;
    o.Radii = { { near, far } };
    o.Mapping = mapping;
    const View view(*FindProjection("equirectangular"), o);
    std::vector<Texel> out;
    std::vector<Texel> unused;
    ASSERT_TRUE(gpu.Evaluate(view, distances, distances, out, unused));
    double worst = 0;
    long backwards = 0;
    for (int i = 0; i < Count; ++i)
    {
      const double depth = wfvDepthOf(distances[i][3], view.GetParameters());
      worst = std::max(worst, std::abs(out[i][2] - depth));
      backwards += i > 0 && out[i][2] < out[i - 1][2] - DepthAgreement;
    }
    std::cout << "depth mapping " << int(mapping) << ": " << worst << "\n";
    EXPECT_LE(worst, DepthAgreement) << int(mapping);
    EXPECT_EQ(backwards, 0) << int(mapping);
  }
}
