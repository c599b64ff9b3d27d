// SPDX-License-Identifier: BSD-3-Clause
// A march through an image in double precision, by the rules of VTK's GPU ray casting: what drawn
// volumes are measured against. It has the transfer functions themselves, not tables of them.
#ifndef WideFoVVolumeMarch_h
#define WideFoVVolumeMarch_h

#include "Projections/Projection.h"

#include <array>
#include <functional>
#include <vector>

namespace wfv
{
namespace reference
{
// Values at the points of an image, x fastest.
struct Field
{
  std::array<int, 3> Size{ { 0, 0, 0 } };
  vec3 Origin{ 0 };
  vec3 Spacing{ 1 };
  std::vector<double> Values;

  vec3 GetHigh() const;

  // Trilinear between the points; beyond them what is at the border.
  double At(const vec3& place) const;

  double Get(int i, int j, int k) const
  {
    return this->Values[(std::size_t(k) * this->Size[1] + j) * this->Size[0] + i];
  }

  // VTK maps a place to its texture in two ways: as that of a point, and, where it cuts, crops and,
  // up to 9.5, clips, as that of a cell. This is the place that the second takes for another's: by
  // up to half a cell towards the middle. And how much shorter ways then are, which is one number
  // for images with as many points on each axis.
  vec3 AsCell(const vec3& place) const;
  double CellScale() const { return (this->Size[0] - 1.0) / this->Size[0]; }

  // Central differences of one cell's size, as light takes them.
  vec3 Gradient(const vec3& place) const;
};

enum class Blend
{
  Composite,
  Maximum,
  Minimum,
  Average,
  Additive,
  Isosurface,
  Slice
};

struct Plane
{
  vec3 Origin;
  vec3 Normal; // the volume is kept on the side it points to
};

struct Rgba
{
  vec3 Color{ 0 }; // times opacity
  double Alpha = 0;
};

struct VolumeMarch
{
  Field Data;
  Blend Mode = Blend::Composite;
  double Step = 1;
  std::function<double(double)> Opacity; // of a value, for a unit of length
  std::function<vec3(double)> Color;
  std::function<double(double)> GradientOpacity; // of a share of a quarter of the range; none: 1
  std::array<double, 2> Range{ { 0, 1 } };       // of the values
  std::vector<Plane> Clips;
  bool ClipsAsCells = false;                             // as VTK does up to 9.5
  std::array<double, 6> Cropped{ { 0, 0, 0, 0, 0, 0 } }; // the box that is kept
  bool Crops = false;
  bool Shades = false;  // by a headlight, VTK's default material
  bool Mirrors = false; // highlights by the mirrored ray, as since VTK 9.2; else halfway
  std::vector<double> Isovalues;
  Plane Cut{ vec3(0), vec3(0, 0, 1) };

  // What a straight line sees.
  Rgba March(const vec3& origin, const vec3& direction, double near, double far) const;

  // What is seen along a curve: the place at a distance from the origin, or none where it is
  // outside of the picture.
  using Curve = std::function<bool(double distance, vec3& place)>;
  Rgba MarchCurve(const vec3& origin, const Curve& curve, double near, double far) const;

private:
  bool IsInside(const vec3& place) const;
  bool IsClipped(const vec3& place) const;
  bool FindEntry(const Curve& curve, double near, double far, double& entry) const;
  struct Ray;
  struct Sum;
  double CorrectedOpacity(double value) const;
  Rgba Lit(const Ray& ray, const vec3& place, double value, double opacity) const;
  bool Skips(const vec3& place) const;
  bool Clip(Ray& ray) const;
  void Take(const Ray& ray, const vec3& place, long number, Sum& sum) const;
  void TakeContour(const Ray& ray, const vec3& place, double value, long number, Sum& sum) const;
  Rgba Finish(const Ray& ray, const Sum& sum) const;
  Rgba CutByPlane(const Ray& ray) const;
  Rgba CutByPlane(const vec3& place, const Ray& ray) const;
};
}
}

#endif
