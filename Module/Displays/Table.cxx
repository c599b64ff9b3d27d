// SPDX-License-Identifier: BSD-3-Clause
#include "Table.h"

#include <algorithm>

namespace wfv::displays
{
namespace
{
// Widths of a picture: so far outside of it a place still counts as on its border.
constexpr double BorderRounding = 1e-6;

// Returns the picture that a calibration refers to: its own frustum, or else the caller's.
Content ContentOf(const Calibration& calibration, const Content& content)
{
  if (calibration.Content)
  {
    const Frustum frustum = *calibration.Content;
    return [frustum](vec2 uv) { return frustum.DirectionAt(uv); };
  }
  if (!content)
  {
    throw FileError(
      calibration.Path + " says places in a picture, and not in which: name its projection");
  }
  return content;
}

void LookUp(const Content& content, Table& table)
{
  for (vec3& value : table.Values)
  {
    const bool inside = value.x >= -BorderRounding && value.x <= 1 + BorderRounding &&
      value.y >= -BorderRounding && value.y <= 1 + BorderRounding; // no NaN either
    value = inside ? content(vec2(value)) : vec3(std::nan(""));
  }
}

// alpha multiplies; beta is added, and what is multiplied leaves room for it.
void ApplyMasks(const Calibration& calibration, double projectorGamma, Table& table)
{
  const double gamma =
    calibration.Gamma == Calibration::ProjectorGamma ? projectorGamma : calibration.Gamma;
  const bool hasAlpha = calibration.Alpha.Width > 0;
  const bool hasBeta = calibration.Beta.Width > 0;
  if (hasBeta)
  {
    table.Lift.assign(table.Count(), 0);
  }
  for (std::size_t i = 0; i < table.Count(); i++)
  {
    const double x = (double(i % table.Width) + 0.5) / table.Width;
    const double y = (double(i / table.Width) + 0.5) / table.Height;
    const auto linear = [&](double stored) { return std::pow(stored, gamma); };
    double light = linear(table.Brightness[i]);
    light *= hasAlpha ? linear(MaskAt(calibration.Alpha, x, y)) : 1;
    if (hasBeta)
    {
      const double lift = linear(MaskAt(calibration.Beta, x, y));
      table.Lift[i] = static_cast<float>(lift);
      light *= 1 - lift;
    }
    table.Brightness[i] = std::isnan(table.Values[i].x) ? 0 : static_cast<float>(light);
  }
}
}

Table MakeTable(
  const Calibration& calibration, int width, int height, const Content& content, double gamma)
{
  Table table;
  table.Width = width;
  table.Height = height;
  Raster shown{ width, height, {} };
  if (calibration.Pixels.Width > 0)
  {
    shown = Resampled(calibration.Pixels, width, height);
    table.Brightness.assign(table.Count(), 1);
  }
  else if (calibration.Mesh.Triangles.empty())
  {
    throw FileError(calibration.Path +
      " says where the projector is and not what it shows; name the surface in a display file");
  }
  else
  {
    DrawMesh(calibration.Mesh, shown, table.Brightness);
  }
  table.Values = std::move(shown.Values);
  if (calibration.What == Shows::Picture)
  {
    LookUp(ContentOf(calibration, content), table);
  }
  else
  {
    table.What = calibration.What;
  }
  ApplyMasks(calibration, gamma, table);
  const auto dark = [](const vec3& v) { return std::isnan(v.x); };
  if (std::all_of(table.Values.begin(), table.Values.end(), dark))
  {
    throw FileError(calibration.Path + " shows nothing in " + std::to_string(width) + "x" +
      std::to_string(height) + " pixels; check the size");
  }
  return table;
}

std::vector<float> DirectionsFrom(const Table& table, const vec3& eye)
{
  std::vector<float> directions;
  directions.reserve(3 * table.Count());
  for (const vec3& value : table.Values)
  {
    const vec3 from = table.What == Shows::Point ? value - eye : value;
    const double length = glm::length(from);
    const vec3 unit = length > 0 ? from / length : vec3(0); // NaN is not above 0
    for (int i = 0; i < 3; i++)
    {
      directions.push_back(static_cast<float>(unit[i]));
    }
  }
  return directions;
}

void ApplyMask(const std::string& path, const Mask& mask, double gamma, Table& table)
{
  if (mask.Width != table.Width || mask.Height != table.Height)
  {
    throw FileError(path + " is " + std::to_string(mask.Width) + "x" + std::to_string(mask.Height) +
      " pixels, its projector " + std::to_string(table.Width) + "x" + std::to_string(table.Height) +
      "; a mask has a value a pixel");
  }
  for (std::size_t i = 0; i < table.Count(); i++)
  {
    table.Brightness[i] *= static_cast<float>(std::pow(double(mask.Values[i]), gamma));
  }
}

double Lit(double value, double brightness, double lift, double gamma)
{
  const double light = brightness * std::pow(std::clamp(value, 0., 1.), gamma) + lift;
  return std::pow(std::clamp(light, 0., 1.), 1 / gamma);
}
}
