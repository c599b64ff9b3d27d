// SPDX-License-Identifier: BSD-3-Clause
#include "SampledLines.h"

#include "LineArc.h"
#include "OwnMap.h"

#include <algorithm>
#include <cmath>

namespace wfv
{
namespace reference
{
namespace
{
// Thirds by which the nearest point is closed in on, and halves for how far along the line is as
// near.
constexpr int Thirds = 60;
constexpr int Halves = 60;

// Radians from the plane of the pixel's map: nothing is looked for farther aside.
constexpr double Aside = 1e-6;

// The line as one pixel sees it.
class Sighting
{
public:
  Sighting(const Arc& arc, const OwnMap& map)
    : TheArc(arc)
    , Map(map)
    , Low(0)
    , High(arc.GetSpan())
  {
    if (arc.IsDots())
    {
      this->Nearest = this->DistanceAt(0) <= this->DistanceAt(this->High) ? 0 : this->High;
      return;
    }
    // half a turn of it lies ahead
    const double middle = 0.5 * this->High;
    const double peak = std::atan2(glm::dot(map.GetNormal(), arc.DirectionAt(WFV_PI / 2)),
      glm::dot(map.GetNormal(), arc.DirectionAt(0)));
    const double ahead = middle + std::remainder(peak - middle, 2 * WFV_PI);
    this->Low = std::max(this->Low, ahead - WFV_PI / 2 + Aside);
    this->High = std::min(this->High, ahead + WFV_PI / 2 - Aside);
    this->Seek();
  }

  double GetDistance() const { return this->DistanceAt(this->Nearest); }

  // The distances from the eye of what is as near, or nearly.
  void AddRho(NearLine& line, double nearest) const
  {
    for (const double end : { this->Low, this->High })
    {
      const double angle =
        this->TheArc.IsDots() ? this->Nearest : this->LastWithin(line.Distance + nearest, end);
      const double rho = this->TheArc.RhoAt(angle);
      line.RhoMin = std::min(line.RhoMin, rho);
      line.RhoMax = std::max(line.RhoMax, rho);
    }
    // the point of a line that is nearest to the eye may be between
    const double rho = this->TheArc.RhoAt(this->Nearest);
    line.RhoMin = std::min(line.RhoMin, rho);
    line.RhoMax = std::max(line.RhoMax, rho);
  }

private:
  double DistanceAt(double angle) const
  {
    return glm::length(this->Map.PlaceOf(this->TheArc.DirectionAt(angle)));
  }

  void Seek()
  {
    double low = this->Low;
    double high = this->High;
    for (int i = 0; i < Thirds && low <= high; i++)
    {
      const double third = (high - low) / 3;
      const bool first = this->DistanceAt(low + third) < this->DistanceAt(high - third);
      (first ? high : low) = first ? high - third : low + third;
    }
    this->Nearest = 0.5 * (low + high);
    for (const double end : { this->Low, this->High })
    {
      this->Nearest = this->DistanceAt(end) < this->GetDistance() ? end : this->Nearest;
    }
  }

  double LastWithin(double distance, double end) const
  {
    double in = this->Nearest;
    double out = end;
    for (int i = 0; i < Halves && (this->DistanceAt(out) > distance); i++)
    {
      const double middle = 0.5 * (in + out);
      const bool within = this->DistanceAt(middle) <= distance;
      (within ? in : out) = middle;
    }
    return this->DistanceAt(out) <= distance ? out : in;
  }

  const Arc& TheArc;
  const OwnMap& Map;
  double Low;
  double High;
  double Nearest = 0;
};
}

LinePicture RenderSampledLines(const std::vector<Segment>& segments, const View& view, int width,
  int height, double reach, double nearest)
{
  Window window;
  window.Width = width;
  window.Height = height;
  std::vector<Arc> arcs;
  for (const Segment& segment : segments)
  {
    arcs.emplace_back(segment, view, window, nullptr);
  }
  LinePicture picture;
  for (int j = 0; j < height; j++)
  {
    for (int i = 0; i < width; i++)
    {
      const OwnMap map(view, i, j, width, height);
      for (std::size_t k = 0; map.IsShown() && k < arcs.size(); k++)
      {
        const Sighting seen(arcs[k], map);
        NearLine line;
        line.Cell = segments[k].Cell;
        line.Distance = seen.GetDistance();
        if (line.Distance <= reach)
        {
          seen.AddRho(line, nearest);
          picture[long(j) * width + i].push_back(line);
        }
      }
    }
  }
  return picture;
}
}
}
