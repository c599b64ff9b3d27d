// SPDX-License-Identifier: BSD-3-Clause
#include "VolumeMarch.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wfv
{
namespace reference
{
namespace
{
// From here on nothing behind is added: VTK's own.
constexpr double Opaque = 1 - 1.0 / 255;

// Opacities up to this are not corrected for the length of a step: VTK's own.
constexpr double Clear = 0.0001;

// Of VTK's volumes: what light does that a headlight gives.
constexpr double Ambient = 0.1;
constexpr double Diffuse = 0.7;
constexpr double Specular = 0.2;
constexpr double SpecularPower = 10;

// The share of the range that a gradient's full length is.
constexpr double GradientShare = 0.25;
}

vec3 Field::GetHigh() const
{
  return this->Origin +
    this->Spacing * vec3(this->Size[0] - 1, this->Size[1] - 1, this->Size[2] - 1);
}

vec3 Field::AsCell(const vec3& place) const
{
  const vec3 points(this->Size[0], this->Size[1], this->Size[2]);
  const vec3 index = (place - this->Origin) / this->Spacing;
  return this->Origin + (index + 0.5) * (points - 1.0) / points * this->Spacing;
}

double Field::At(const vec3& place) const
{
  int low[3];
  double t[3];
  for (int a = 0; a < 3; a++)
  {
    const double x =
      std::clamp((place[a] - this->Origin[a]) / this->Spacing[a], 0.0, double(this->Size[a] - 1));
    low[a] = std::min(static_cast<int>(x), std::max(0, this->Size[a] - 2));
    t[a] = x - low[a];
  }
  double value = 0;
  for (int c = 0; c < 8; c++)
  {
    double share = 1;
    int at[3];
    for (int a = 0; a < 3; a++)
    {
      const int high = (c >> a) & 1;
      at[a] = std::min(low[a] + high, this->Size[a] - 1);
      share *= high ? t[a] : 1 - t[a];
    }
    value += share * this->Get(at[0], at[1], at[2]);
  }
  return value;
}

vec3 Field::Gradient(const vec3& place) const
{
  vec3 gradient(0);
  for (int a = 0; a < 3; a++)
  {
    vec3 step(0);
    // VTK's step: its texture has a texel a point, and this is one of as many cells
    step[a] = this->Spacing[a] * this->Size[a] / (this->Size[a] - 1.0);
    gradient[a] = (this->At(place + step) - this->At(place - step)) / this->Spacing[a];
  }
  return gradient;
}

struct VolumeMarch::Ray
{
  vec3 Origin;
  vec3 Direction;
  double Start; // of the first sample, distances from the origin
  double Stop;  // of the surface behind
};

struct VolumeMarch::Sum
{
  Rgba Front;
  double Value = 0;
  long Count = 0; // of what is averaged; of extremes: whether there is one
  int Level = 0;  // how many isovalues are below the value
};

double VolumeMarch::CorrectedOpacity(double value) const
{
  const double opacity = this->Opacity(value);
  if (opacity <= Clear)
  {
    return opacity;
  }
  if (this->Mode == Blend::Composite)
  {
    return 1 - std::pow(1 - opacity, this->Step);
  }
  return this->Mode == Blend::Additive ? opacity * this->Step : opacity;
}

Rgba VolumeMarch::Lit(const Ray& ray, const vec3& place, double value, double opacity) const
{
  Rgba lit{ this->Color(value), opacity };
  const vec3 gradient =
    this->Shades || this->GradientOpacity ? this->Data.Gradient(place) : vec3(0);
  if (this->GradientOpacity)
  {
    // VTK's mean of the spacings is of one: these images have the same spacing everywhere
    const double size = 0.5 * glm::length(gradient * this->Data.Spacing);
    const double range = this->Range[1] - this->Range[0];
    lit.Alpha *= this->GradientOpacity(std::min(1.0, size / (GradientShare * range)));
  }
  if (this->Shades && this->Mode != Blend::Maximum && this->Mode != Blend::Minimum)
  {
    const double length = glm::length(gradient);
    const vec3 normal = length > 0 ? gradient / length : vec3(0);
    const vec3 toEye = glm::normalize(place - ray.Origin);
    const double cosine = std::abs(glm::dot(normal, toEye)); // of both sides
    const double highlight = this->Mirrors ? std::max(0.0, 2 * cosine * cosine - 1) : cosine;
    lit.Color = lit.Color * (Ambient + Diffuse * cosine) +
      vec3(Specular * std::pow(highlight, SpecularPower));
  }
  lit.Color = glm::clamp(lit.Color, 0.0, 1.0) * lit.Alpha;
  return lit;
}

bool VolumeMarch::Skips(const vec3& place) const
{
  const vec3 p = this->Data.AsCell(place);
  const std::array<double, 6>& c = this->Cropped;
  return this->Crops &&
    (p.x < c[0] || p.x >= c[1] || p.y < c[2] || p.y >= c[3] || p.z < c[4] || p.z >= c[5]);
}

// As VTK tightens what is sampled; false: nothing is left.
bool VolumeMarch::Clip(Ray& ray) const
{
  for (const Plane& plane : this->Clips)
  {
    const vec3 normal = glm::normalize(plane.Normal);
    const double entry = ray.Start - this->Step;
    const auto beyond = [&](double t) {
      const vec3 place = ray.Origin + t * ray.Direction;
      return glm::dot(
        normal, plane.Origin - (this->ClipsAsCells ? this->Data.AsCell(place) : place));
    };
    const double first = beyond(entry);
    const double last = beyond(ray.Stop);
    if (first > 0 && last > 0)
    {
      return false;
    }
    const double slope =
      glm::dot(normal, ray.Direction) * (this->ClipsAsCells ? this->Data.CellScale() : 1.0);
    if (slope > 0 && first > 0)
    {
      ray.Start = entry + first / slope + this->Step;
    }
    if (!(slope > 0) && last > 0)
    {
      ray.Stop += last / slope;
    }
  }
  const vec3 start = ray.Origin + ray.Start * ray.Direction;
  const vec3 high = this->Data.GetHigh();
  return this->Clips.empty() ||
    (glm::all(glm::greaterThanEqual(start, this->Data.Origin)) &&
      glm::all(glm::lessThanEqual(start, high)));
}

void VolumeMarch::TakeContour(
  const Ray& ray, const vec3& place, double value, long number, Sum& sum) const
{
  const auto levels = static_cast<int>(this->Isovalues.size());
  int level = 0;
  while (level < levels && value > this->Isovalues[level])
  {
    level++;
  }
  // by one level a sample, as VTK counts
  const int before = sum.Level;
  sum.Level = number == 0 ? level : before + (level > before) - (level < before);
  if (number == 0 || sum.Level == before)
  {
    return;
  }
  const double met = this->Isovalues[std::min(before, sum.Level)];
  const Rgba lit = this->Lit(ray, place, met, this->CorrectedOpacity(met));
  sum.Front.Color += (1 - sum.Front.Alpha) * lit.Color;
  sum.Front.Alpha += (1 - sum.Front.Alpha) * lit.Alpha;
}

void VolumeMarch::Take(const Ray& ray, const vec3& place, long number, Sum& sum) const
{
  if (this->Skips(place))
  {
    return;
  }
  const double value = this->Data.At(place);
  const double share = (value - this->Range[0]) / (this->Range[1] - this->Range[0]);
  switch (this->Mode)
  {
    case Blend::Maximum:
      sum.Value = sum.Count++ > 0 ? std::max(sum.Value, value) : value;
      break;
    case Blend::Minimum:
      sum.Value = sum.Count++ > 0 ? std::min(sum.Value, value) : value;
      break;
    case Blend::Average:
    case Blend::Additive:
      sum.Value += this->CorrectedOpacity(value) * share;
      sum.Count++;
      break;
    case Blend::Isosurface:
      this->TakeContour(ray, place, value, number, sum);
      break;
    default:
    {
      const double opacity = this->CorrectedOpacity(value);
      if (opacity > 0)
      {
        const Rgba lit = this->Lit(ray, place, value, opacity);
        sum.Front.Color += (1 - sum.Front.Alpha) * lit.Color;
        sum.Front.Alpha += (1 - sum.Front.Alpha) * lit.Alpha;
      }
    }
  }
}

Rgba VolumeMarch::Finish(const Ray& ray, const Sum& sum) const
{
  const double grey = std::clamp(sum.Value, 0.0, 1.0);
  switch (this->Mode)
  {
    case Blend::Maximum:
    case Blend::Minimum:
    {
      // VTK's, where every sample is skipped
      const double none = this->Range[this->Mode == Blend::Minimum];
      const double value = sum.Count > 0 ? sum.Value : none;
      return this->Lit(ray, ray.Origin, value, this->CorrectedOpacity(value));
    }
    case Blend::Average:
      return sum.Count > 0 ? Rgba{ vec3(std::clamp(sum.Value / double(sum.Count), 0.0, 1.0)), 1 }
                           : Rgba();
    case Blend::Additive:
      return { vec3(grey), 1 };
    default:
      return sum.Front;
  }
}

bool VolumeMarch::IsInside(const vec3& place) const
{
  return glm::all(glm::greaterThanEqual(place, this->Data.Origin)) &&
    glm::all(glm::lessThanEqual(place, this->Data.GetHigh()));
}

Rgba VolumeMarch::CutByPlane(const vec3& place, const Ray& ray) const
{
  // of the texture's coordinates, which are taken for those of a point
  const vec3 points(this->Data.Size[0], this->Data.Size[1], this->Data.Size[2]);
  const vec3 share = (place - this->Data.Origin) / (this->Data.GetHigh() - this->Data.Origin);
  const vec3 sampled = this->Data.Origin + (share * points - 0.5) * this->Data.Spacing;
  const double value = this->Data.At(sampled);
  return this->Lit(ray, sampled, value, this->CorrectedOpacity(value));
}

Rgba VolumeMarch::CutByPlane(const Ray& ray) const
{
  const double slope = glm::dot(this->Cut.Normal, ray.Direction);
  const double t = glm::dot(this->Cut.Origin - ray.Origin, this->Cut.Normal) / slope;
  const vec3 place = ray.Origin + t * ray.Direction;
  return t > 0 && t < ray.Stop && this->IsInside(place) ? this->CutByPlane(place, ray) : Rgba();
}

Rgba VolumeMarch::March(const vec3& origin, const vec3& direction, double near, double far) const
{
  const vec3 high = this->Data.GetHigh();
  double first = near;
  double last = std::numeric_limits<double>::infinity();
  for (int a = 0; a < 3; a++)
  {
    const double u = (this->Data.Origin[a] - origin[a]) / direction[a];
    const double v = (high[a] - origin[a]) / direction[a];
    first = std::max(first, std::min(u, v));
    last = std::min(last, std::max(u, v));
  }
  if (!(first < last) || first >= far)
  {
    return Rgba();
  }
  Ray ray{ origin, direction, first + this->Step, far };
  if (this->Mode == Blend::Slice)
  {
    return this->CutByPlane(ray);
  }
  if (!this->Clip(ray))
  {
    return Rgba();
  }
  Sum sum;
  const double steps = std::abs(ray.Stop - ray.Start) / this->Step;
  for (long n = 0;; n++)
  {
    const double t = ray.Start + double(n) * this->Step;
    this->Take(ray, origin + t * direction, n, sum);
    if (t + this->Step > last || sum.Front.Alpha > Opaque || double(n) >= steps)
    {
      return this->Finish(ray, sum);
    }
  }
}

bool VolumeMarch::IsClipped(const vec3& place) const
{
  return std::any_of(this->Clips.begin(), this->Clips.end(),
    [&place](const Plane& plane) { return glm::dot(plane.Origin - place, plane.Normal) > 0; });
}

// The first distance at which the curve is in the box, looked for in short steps.
bool VolumeMarch::FindEntry(const Curve& curve, double near, double far, double& entry) const
{
  const auto inside = [&](double t) {
    vec3 place;
    return curve(t, place) && this->IsInside(place);
  };
  double before = near;
  for (double t = near; t < far; t += 0.25 * this->Step)
  {
    if (inside(t))
    {
      double behind = t;
      for (int i = 0; i < 50 && t > near; i++)
      {
        const double middle = 0.5 * (before + behind);
        (inside(middle) ? behind : before) = middle;
      }
      entry = behind;
      return true;
    }
    before = t;
  }
  return false;
}

Rgba VolumeMarch::MarchCurve(const vec3& origin, const Curve& curve, double near, double far) const
{
  const double size = glm::length(this->Data.GetHigh() - this->Data.Origin);
  const double end = glm::length(this->Data.GetHigh() - origin) + size;
  double entry = 0;
  if (!this->FindEntry(curve, near, std::min(far, end), entry))
  {
    return Rgba();
  }
  const Ray ray{ origin, vec3(0), entry + this->Step, far };
  const double steps = std::abs(ray.Stop - ray.Start) / this->Step;
  Sum sum;
  for (long n = 0; double(n) <= steps + 1 && sum.Front.Alpha <= Opaque; n++)
  {
    const double t = ray.Start + double(n) * this->Step;
    vec3 place;
    if (t > end)
    {
      break;
    }
    if (curve(t, place) && this->IsInside(place) && !this->IsClipped(place))
    {
      this->Take(ray, place, n, sum);
    }
  }
  return this->Finish(ray, sum);
}
}
}
