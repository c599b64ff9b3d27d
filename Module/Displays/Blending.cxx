// SPDX-License-Identifier: BSD-3-Clause
#include "Blending.h"

#include "EdgeDistance.h"
#include "Projections/DirectionMap.h"
#include "Projections/Projection.h"

#include <algorithm>
#include <thread>

namespace wfv::displays
{
namespace
{
// Steps between the neighbours of a pixel: a point that is nearer to what the pixel shows is lit by
// it, a farther one lies behind or before it.
constexpr double SameSurface = 4;

// Finds where a projector shows a direction or a point.
class Finder
{
public:
  Finder(const Table& table, const vec3& center)
    : Shown(table)
    , Center(center)
    , Edges(table)
    , Wide(SampledProjection(), Options(table, center))
  {
    this->FindCone();
  }

  // The weight of the projector at this place: 0 where it shows nothing of it.
  double Weight(const vec3& value) const
  {
    const bool isPoint = this->Shown.What == Shows::Point;
    const vec3 direction = glm::normalize(isPoint ? value - this->Center : value);
    if (glm::dot(direction, this->Axis) < this->LeastCosine)
    {
      return 0;
    }
    const NdcPoint found = this->Wide.Forward(direction);
    if (std::abs(found.Ndc.x) > 1 || std::abs(found.Ndc.y) > 1)
    {
      return 0;
    }
    const double x = 0.5 * (found.Ndc.x + 1) * this->Shown.Width - 0.5;
    const double y = 0.5 * (found.Ndc.y + 1) * this->Shown.Height - 0.5;
    return isPoint && !this->Lights(x, y, value) ? 0 : this->WeightAt(x, y);
  }

  double WeightAt(double x, double y) const
  {
    const double distance = this->Edges.At(x, y);
    return distance * distance;
  }

private:
  static ViewOptions Options(const Table& table, const vec3& center)
  {
    ViewOptions options;
    options.Map = std::make_shared<const DirectionMap>(
      table.Width, table.Height, DirectionsFrom(table, center));
    options.Aspect = double(table.Width) / table.Height;
    return options;
  }

  // True where the pixel at this place shows this point, and none before or behind it.
  bool Lights(double x, double y, const vec3& point) const
  {
    const int column = std::clamp(static_cast<int>(std::lround(x)), 1, this->Shown.Width - 2);
    const int row = std::clamp(static_cast<int>(std::lround(y)), 1, this->Shown.Height - 2);
    const vec3* const at =
      &this->Shown.Values[static_cast<std::size_t>(row) * this->Shown.Width + column];
    double step = 0;
    for (const int neighbour : { -1, 1, -this->Shown.Width, this->Shown.Width })
    {
      const double length = glm::length(at[neighbour] - *at);
      step = std::max(step, std::isnan(length) ? 0 : length);
    }
    return !(glm::length(point - *at) > SameSurface * step); // at a hole it counts as lit
  }

  // A cone that holds all directions.
  void FindCone()
  {
    const std::vector<float> all = DirectionsFrom(this->Shown, this->Center);
    const auto at = [&all](std::size_t i) { return vec3(all[i], all[i + 1], all[i + 2]); };
    vec3 sum(0);
    for (std::size_t i = 0; i < all.size(); i += 3)
    {
      sum += at(i);
    }
    const double length = glm::length(sum);
    this->Axis = length > 0 ? sum / length : vec3(0);
    for (std::size_t i = 0; i < all.size(); i += 3)
    {
      const vec3 d = at(i);
      this->LeastCosine =
        d == vec3(0) ? this->LeastCosine : std::min(this->LeastCosine, glm::dot(d, this->Axis));
    }
    this->LeastCosine -= 1e-3; // half a pixel beyond the last centres
  }

  const Table& Shown;
  vec3 Center;
  EdgeDistance Edges;
  View Wide;
  vec3 Axis{ 0 };
  double LeastCosine = 1;
};

// Directions are all that is compared where some tables have no points.
std::vector<Table> AsDirections(std::vector<Table> tables, const vec3& eye)
{
  for (Table& table : tables)
  {
    for (vec3& value : table.Values)
    {
      value = table.What == Shows::Point ? glm::normalize(value - eye) : value;
    }
    table.What = Shows::Direction;
  }
  return tables;
}

// Light of all projectors at one pixel.
struct Overlap
{
  float Share = 0; // of the projector's own, 0 to 1
  float Black = 0; // sum of the black levels
};

void Measure(const std::vector<Finder>& finders, const std::vector<Table>& tables,
  const std::vector<double>& blackLevels, std::size_t own, std::vector<Overlap>& overlaps)
{
  const Table& table = tables[own];
  overlaps.resize(table.Count());
  const auto part = [&](std::size_t first, std::size_t step) {
    for (std::size_t i = first; i < table.Count(); i += step)
    {
      const vec3& value = table.Values[i];
      if (std::isnan(value.x))
      {
        continue;
      }
      const double mine = finders[own].WeightAt(double(i % table.Width), double(i / table.Width));
      double sum = mine;
      double black = blackLevels[own];
      for (std::size_t other = 0; other < finders.size(); other++)
      {
        const double weight = other == own ? 0 : finders[other].Weight(value);
        sum += weight;
        black += weight > 0 ? blackLevels[other] : 0;
      }
      overlaps[i] = { static_cast<float>(mine / sum), static_cast<float>(black) };
    }
  };
  const std::size_t count = std::max(1u, std::thread::hardware_concurrency());
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < count; i++)
  {
    threads.emplace_back(part, i, count);
  }
  for (std::thread& thread : threads)
  {
    thread.join();
  }
}

// Sets the brightness and the lift of a projector, so that the black levels of all projectors add
// up to `most` at every pixel.
void SetLight(
  Table& table, const std::vector<Overlap>& overlaps, double blackLevel, double most, Masks masks)
{
  table.Lift.assign(most > 0 ? table.Count() : 0, 0);
  for (std::size_t i = 0; i < table.Count(); i++)
  {
    const double share = overlaps[i].Share;
    const double light = masks == Masks::Given ? table.Brightness[i] : share;
    table.Brightness[i] = static_cast<float>(light * (1 - most) / (1 - blackLevel));
    if (most > 0)
    {
      table.Lift[i] = static_cast<float>(share * (most - overlaps[i].Black) / (1 - blackLevel));
    }
  }
}
}

void Blend(
  std::vector<Table>& tables, const std::vector<double>& blackLevels, const vec3& eye, Masks masks)
{
  const bool points = std::all_of(
    tables.begin(), tables.end(), [](const Table& t) { return t.What == Shows::Point; });
  const std::vector<Table> seen = points ? tables : AsDirections(tables, eye);
  std::vector<Finder> finders;
  finders.reserve(seen.size());
  for (const Table& table : seen)
  {
    finders.emplace_back(table, points ? table.Center.value_or(eye) : eye);
  }
  std::vector<std::vector<Overlap>> overlaps(seen.size());
  double most = 0;
  for (std::size_t i = 0; i < seen.size(); i++)
  {
    Measure(finders, seen, blackLevels, i, overlaps[i]);
    for (const Overlap& overlap : overlaps[i])
    {
      most = std::max(most, double(overlap.Black));
    }
  }
  for (std::size_t i = 0; i < seen.size(); i++)
  {
    SetLight(tables[i], overlaps[i], blackLevels[i], most, masks);
  }
}
}
