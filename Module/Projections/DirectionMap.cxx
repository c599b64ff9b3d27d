// SPDX-License-Identifier: BSD-3-Clause
#include "DirectionMap.h"

#include "DirectionMap/DirectionTables.h"

#include <algorithm>
#include <atomic>
#include <cmath>

namespace wfv
{
using namespace tables;

namespace
{
// There is a discontinuity between neighbours where their step is longer than so many times the
// shorter of the steps before and behind it, and than so many times the usual step.
constexpr double GapRatio = 4;
constexpr double GapSteps = 2;

// Radians: a longer step with no other in line is a discontinuity.
constexpr double LonelyStep = 0.35;

// The corners of a pixel are half its steps away, and these are not quite the same on its
// sides.
constexpr double RadiusSafety = 1.3;

// Pixels from the centre: where the edge of a pixel is looked at.
constexpr double JustInside = 0.4999;

// Cells along a face at the most: 50 MB of tables.
constexpr int MostCells = 512;

// Pixels looked at for what is usual.
constexpr std::size_t MostSamples = 100000;

unsigned long NextSerial()
{
  static std::atomic<unsigned long> last{ 0 };
  return ++last;
}

double Median(std::vector<double> values)
{
  if (values.empty())
  {
    return 0;
  }
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// Lengths of the steps along one axis; negative where there is none.
class Steps
{
public:
  Steps(const std::vector<Texel>& directions, int width, int height, int dx)
    : Width(width)
    , Height(height)
    , Dx(dx)
    , Lengths(directions.size(), -1.f)
  {
    const std::size_t next = dx ? 1 : static_cast<std::size_t>(width);
    for (int y = 0; y < height - (1 - dx); y++)
    {
      for (int x = 0; x < width - dx; x++)
      {
        const std::size_t i = static_cast<std::size_t>(y) * width + x;
        if (directions[i][3] != 0 && directions[i + next][3] != 0)
        {
          const vec3 step = DirectionOf(directions[i + next]) - DirectionOf(directions[i]);
          this->Lengths[i] = static_cast<float>(glm::length(step));
        }
      }
    }
    std::vector<double> some;
    const std::size_t stride = 1 + this->Lengths.size() / MostSamples;
    for (std::size_t i = 0; i < this->Lengths.size(); i += stride)
    {
      if (this->Lengths[i] >= 0)
      {
        some.push_back(this->Lengths[i]);
      }
    }
    this->Usual = Median(some);
  }

  double At(int x, int y) const
  {
    const bool there = x >= 0 && y >= 0 && x < this->Width && y < this->Height;
    return there ? this->Lengths[static_cast<std::size_t>(y) * this->Width + x] : -1;
  }

  // The step from this pixel to the next one is there, and whole.
  bool Hangs(int x, int y) const
  {
    const double step = this->At(x, y);
    const double before = this->At(x - this->Dx, y - (1 - this->Dx));
    const double after = this->At(x + this->Dx, y + (1 - this->Dx));
    if (step < 0)
    {
      return false;
    }
    if (before < 0 && after < 0)
    {
      return step <= LonelyStep;
    }
    const double other = before < 0 ? after : after < 0 ? before : std::min(before, after);
    return step <= std::max(GapRatio * other, GapSteps * this->Usual);
  }

private:
  int Width;
  int Height;
  int Dx;
  std::vector<float> Lengths;
  double Usual = 0;
};
}

namespace tables
{
double RadiusOf(const DirectionMap& map, int x, int y)
{
  const std::vector<Texel>& all = map.GetDirections();
  const std::ptrdiff_t width = map.GetWidth();
  const Texel* const here = &all[static_cast<std::size_t>(y * width + x)];
  const vec3 d = DirectionOf(*here);
  double chord = 0;
  if ((static_cast<int>((*here)[3]) & WFV_PIXEL_SIMPLE) != 0)
  {
    const auto step = [&](std::ptrdiff_t to) { return glm::length(DirectionOf(here[to]) - d); };
    chord = 0.5 * (std::max(step(1), step(-1)) + std::max(step(width), step(-width)));
  }
  else
  {
    WfvView view{};
    view.tables = map.GetSizes();
    view.map = &map;
    for (int k = 0; k < 9; k++)
    {
      // just inside, where the pixel is this one
      const int column = k % 3 - 1;
      const int row = k / 3 - 1;
      const vec2 at(x + JustInside * column, y + JustInside * row);
      chord = std::max(chord, glm::length(wfvRayOfPixel(at, view).direction - d));
    }
  }
  return RadiusSafety * WFV_CAP_ANGLE * chord;
}
}

std::string DirectionMap::Check(int width, int height, const std::vector<float>& directions)
{
  if (width < 2 || height < 2 ||
    directions.size() != 3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height))
  {
    return "a direction map needs at least 2 x 2 pixels of three numbers each";
  }
  bool any = false;
  for (std::size_t i = 0; i < directions.size(); i += 3)
  {
    const vec3 d(directions[i], directions[i + 1], directions[i + 2]);
    const double length = glm::length(d);
    if (std::abs(length - 1) <= UnitSlack)
    {
      any = true;
    }
    else if (length != 0)
    {
      const std::size_t pixel = i / 3;
      const std::size_t row = height - 1 - pixel / width;
      return "the pixel in column " + std::to_string(pixel % width) + " of row " +
        std::to_string(row) +
        (std::isfinite(length) ? " has a direction of the length " + std::to_string(length) +
              ", not 1 (nor 0, for a pixel that shows nothing)"
                               : " has a direction that is not a number");
    }
  }
  return any ? "" : "no pixel has a direction";
}

DirectionMap::DirectionMap(int width, int height, const std::vector<float>& directions)
  : Serial(NextSerial())
  , Width(width)
  , Height(height)
  , Directions(directions.size() / 3)
{
  for (std::size_t i = 0; i < this->Directions.size(); i++)
  {
    const vec3 d(directions[3 * i], directions[3 * i + 1], directions[3 * i + 2]);
    const double length = glm::length(d);
    const vec3 unit = length > 0 ? d / length : d;
    this->Directions[i] = { { static_cast<float>(unit.x), static_cast<float>(unit.y),
      static_cast<float>(unit.z), static_cast<float>(length > 0 ? WFV_PIXEL_VALID : 0) } };
  }
  this->MarkPixels();
  this->ChooseCells();
  this->BoundCells();
  this->FindCellCurvature();
  this->PlantSeeds();
}

void DirectionMap::MarkPixels()
{
  const int w = this->Width;
  const Steps right(this->Directions, w, this->Height, 1);
  const Steps up(this->Directions, w, this->Height, 0);
  const auto changes = [](double a, double b) {
    return a < 0 || b < 0 || std::abs(a - b) > WFV_SIMPLE_CHANGE * std::min(a, b);
  };
  const auto square = [&](int x, int y) {
    return right.Hangs(x, y) && up.Hangs(x, y) && right.Hangs(x, y + 1) && up.Hangs(x + 1, y);
  };
  for (int y = 0; y < this->Height; y++)
  {
    for (int x = 0; x < w; x++)
    {
      Texel& texel = this->Directions[static_cast<std::size_t>(y) * w + x];
      int bits = static_cast<int>(texel[3]);
      for (const Steps* const steps : { &right, &up })
      {
        const double length = steps->Hangs(x, y) ? steps->At(x, y) : 0;
        this->LongestStep = std::max(this->LongestStep, WFV_CAP_ANGLE * length);
      }
      bits |= right.Hangs(x, y) ? WFV_PIXEL_RIGHT : 0;
      bits |= right.Hangs(x - 1, y) ? WFV_PIXEL_LEFT : 0;
      bits |= up.Hangs(x, y) ? WFV_PIXEL_UP : 0;
      bits |= up.Hangs(x, y - 1) ? WFV_PIXEL_DOWN : 0;
      bits |= square(x, y) ? WFV_PIXEL_SQUARE : 0;
      const bool simple = square(x, y) && square(x - 1, y) && square(x, y - 1) &&
        square(x - 1, y - 1) && !changes(right.At(x, y), right.At(x - 1, y)) &&
        !changes(up.At(x, y), up.At(x, y - 1));
      texel[3] = static_cast<float>(simple ? bits | WFV_PIXEL_SIMPLE : bits);
    }
  }
}

void DirectionMap::ChooseCells()
{
  std::vector<double> radii;
  const std::size_t stride = 1 + this->Directions.size() / MostSamples;
  for (std::size_t i = 0; i < this->Directions.size(); i += stride)
  {
    if (this->Directions[i][3] != 0)
    {
      radii.push_back(
        RadiusOf(*this, static_cast<int>(i % this->Width), static_cast<int>(i / this->Width)));
    }
  }
  const double usual = Median(radii);
  while (2 * this->Cells <= MostCells && usual * 2 * this->Cells <= WFV_CAP_SHARE * 0.5 * WFV_PI)
  {
    this->Cells *= 2;
  }
}
}
