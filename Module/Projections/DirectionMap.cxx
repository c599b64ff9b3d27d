// SPDX-License-Identifier: BSD-3-Clause
#include "DirectionMap.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wunused-parameter"
#endif
#define float double
namespace wfv
{
namespace
{
#include "cube_faces.glsl"
#include "direction-map.glsl"
#include "unproject.glsl"
}
}
#undef float
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

namespace wfv
{
namespace
{
using Texel = DirectionMap::Texel;

// Neighbours are torn apart where their step is longer than so many times the shorter of
// the steps before and behind it, and than so many times the usual step.
constexpr double TornRatio = 4;
constexpr double TornSteps = 2;

// Radians: a longer step with no other in line is a tear.
constexpr double LonelyStep = 0.35;

// Calm: how much of a step, at most, it may differ from the one before.
constexpr double CalmChange = 0.05;

// The corners of a pixel are half its steps away, and these are not quite the same on its
// sides; any angle of these sizes over its chord.
constexpr double RadiusSafety = 1.3;
constexpr double AngleOfChord = 1.05;

// Pixels from the centre: where the edge of a pixel is looked at.
constexpr double JustInside = 0.4999;

// Cells along a face at the most: 50 MB of tables.
constexpr int MostCells = 512;

// Pixels: seeds of one cell that are farther apart lie on different pieces of the map.
constexpr double SeedGap = 8;

// Cells that the seeds of one spread to.
constexpr int SpreadRounds = 4;

// Pixels looked at for what is usual.
constexpr std::size_t MostSamples = 100000;

Texel TexelOf(const vec4& v)
{
  return { { static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z),
    static_cast<float>(v.w) } };
}

vec3 DirectionOf(const Texel& t)
{
  return vec3(t[0], t[1], t[2]);
}

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

void Unite(WfvPlaces& a, const WfvPlaces& b)
{
  a = wfvWithPlaces(a, b);
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
    return step <= std::max(TornRatio * other, TornSteps * this->Usual);
  }

private:
  int Width;
  int Height;
  int Dx;
  std::vector<float> Lengths;
  double Usual = 0;
};

// The cells of one level.
struct Level
{
  int Cells;
  std::vector<WfvPlaces> Bounds;

  explicit Level(int cells)
    : Cells(cells)
    , Bounds(6 * static_cast<std::size_t>(cells) * cells, wfvNoPlaces())
  {
  }
  WfvPlaces& At(int column, int row)
  {
    return this->Bounds[static_cast<std::size_t>(row) * 6 * this->Cells + column];
  }
  const WfvPlaces& At(int column, int row) const
  {
    return this->Bounds[static_cast<std::size_t>(row) * 6 * this->Cells + column];
  }
};

// Unites a cell with what lies around it across a border of its face: seven by seven
// places up to a cell's width away.
WfvPlaces AroundBorder(const Level& level, int column, int row)
{
  const int face = column / level.Cells;
  const double angle = 0.5 * WFV_PI / level.Cells;
  WfvPlaces all = wfvNoPlaces();
  for (int i = -2; i <= 4; i++)
  {
    for (int j = -2; j <= 4; j++)
    {
      const double u = (column % level.Cells + 0.5 * i) * angle - 0.25 * WFV_PI;
      const double v = (row + 0.5 * j) * angle - 0.25 * WFV_PI;
      const vec3 d = wfvFromFace(vec3(std::tan(u), std::tan(v), 1), face);
      Unite(all, level.At(wfvCellColumn(d, level.Cells), wfvCellRow(d, level.Cells)));
    }
  }
  return all;
}

// Every cell with its eight neighbours.
Level Dilate(const Level& level)
{
  Level wide(level.Cells);
  const int last = level.Cells - 1;
  for (int row = 0; row <= last; row++)
  {
    for (int column = 0; column < 6 * level.Cells; column++)
    {
      const int i = column % level.Cells;
      if (i == 0 || i == last || row == 0 || row == last)
      {
        wide.At(column, row) = AroundBorder(level, column, row);
        continue;
      }
      for (int k = 0; k < 9; k++)
      {
        Unite(wide.At(column, row), level.At(column - 1 + k % 3, row - 1 + k / 3));
      }
    }
  }
  return wide;
}

// Angle from a pixel's own direction to the farthest that it shows.
double RadiusOf(const DirectionMap& map, int x, int y)
{
  const std::vector<Texel>& all = map.GetDirections();
  const std::ptrdiff_t width = map.GetWidth();
  const Texel* const here = &all[static_cast<std::size_t>(y * width + x)];
  const vec3 d = DirectionOf(*here);
  double chord = 0;
  if ((static_cast<int>((*here)[3]) & WFV_PIXEL_CALM) != 0)
  {
    const auto step = [&](std::ptrdiff_t to) { return glm::length(DirectionOf(here[to]) - d); };
    chord = 0.5 * (std::max(step(1), step(-1)) + std::max(step(width), step(-width)));
  }
  else
  {
    WfvView view{};
    view.tables = vec3(map.GetWidth(), map.GetHeight(), map.GetCells());
    view.map = &map;
    for (int k = 0; k < 9; k++)
    {
      // just inside, where the pixel is this one
      const vec2 at(x + JustInside * (k % 3 - 1), y + JustInside * (k / 3 - 1));
      chord = std::max(chord, glm::length(wfvRayOfPixel(at, view).direction - d));
    }
  }
  return RadiusSafety * AngleOfChord * chord;
}

// Stores each pixel in the cell of its direction, on the finest level that is coarse enough
// for it; level 0 holds those for which none is.
std::vector<Level> StorePixels(const DirectionMap& map)
{
  std::vector<Level> levels{ Level(WFV_COARSEST_CELLS / 2) };
  for (int cells = WFV_COARSEST_CELLS; cells <= map.GetCells(); cells *= 2)
  {
    levels.emplace_back(cells);
  }
  const int width = map.GetWidth();
  const int height = map.GetHeight();
  for (std::size_t i = 0; i < map.GetDirections().size(); i++)
  {
    const Texel& texel = map.GetDirections()[i];
    if (texel[3] == 0)
    {
      continue;
    }
    const int x = static_cast<int>(i % width);
    const int y = static_cast<int>(i / width);
    const double radius = RadiusOf(map, x, y);
    std::size_t l = levels.size() - 1;
    while (l > 0 && radius * levels[l].Cells > WFV_CAP_SHARE * 0.5 * WFV_PI)
    {
      l--;
    }
    const vec3 d = DirectionOf(texel);
    WfvPlaces pixel = wfvNoPlaces();
    pixel.first = vec4(2. * x / width - 1, 2. * y / height - 1, 2. * (x + 1) / width - 1,
      2. * (y + 1) / height - 1);
    pixel.calm = (static_cast<int>(texel[3]) & WFV_PIXEL_CALM) != 0;
    Unite(levels[l].At(wfvCellColumn(d, levels[l].Cells), wfvCellRow(d, levels[l].Cells)), pixel);
  }
  WfvPlaces everywhere = wfvNoPlaces();
  for (const WfvPlaces& cell : levels[0].Bounds)
  {
    Unite(everywhere, cell);
  }
  std::fill(levels[0].Bounds.begin(), levels[0].Bounds.end(), everywhere);
  return levels;
}

// Unites each cell with the one that holds it on the next coarser level.
void UniteWithCoarser(Level& level, const Level& coarser)
{
  for (int row = 0; row < level.Cells; row++)
  {
    for (int column = 0; column < 6 * level.Cells; column++)
    {
      Unite(level.At(column, row), coarser.At(column / 2, row / 2));
    }
  }
}

// Unites each cell with the four that it holds on the next finer level.
void UniteWithFiner(Level& level, const Level& finer)
{
  for (int row = 0; row < finer.Cells; row++)
  {
    for (int column = 0; column < 6 * finer.Cells; column++)
    {
      Unite(level.At(column / 2, row / 2), finer.At(column, row));
    }
  }
}

// The seeds of the cells of one level, a round at a time: in each round the pixel nearest to
// the middle of its cell that is far from the cell's earlier seeds.
class SeedBed
{
public:
  explicit SeedBed(const DirectionMap& map)
    : Map(map)
    , Columns(6 * map.GetCells())
    , Cells(map.GetDirections().size(), -1)
    , Seeds(static_cast<std::size_t>(this->Columns) * map.GetCells())
  {
    const int cells = map.GetCells();
    for (std::size_t i = 0; i < this->Cells.size(); i++)
    {
      const Texel& texel = map.GetDirections()[i];
      if (texel[3] != 0)
      {
        const vec3 d = DirectionOf(texel);
        this->Cells[i] = wfvCellRow(d, cells) * this->Columns + wfvCellColumn(d, cells);
      }
    }
    for (int round = 0; round < WFV_CELL_SEEDS; round++)
    {
      this->Plant(round);
    }
    this->Spread();
  }

  std::vector<Texel> GetTexels() const
  {
    std::vector<Texel> texels;
    for (const auto& seeds : this->Seeds)
    {
      for (int i = 0; i < WFV_CELL_SEEDS; i += 2)
      {
        texels.push_back({ { static_cast<float>(seeds[i].x), static_cast<float>(seeds[i].y),
          static_cast<float>(seeds[i + 1].x), static_cast<float>(seeds[i + 1].y) } });
      }
    }
    return texels;
  }

private:
  struct CellSeeds : std::array<vec2, WFV_CELL_SEEDS>
  {
    CellSeeds() { this->fill(vec2(-1, -1)); }
  };

  vec3 MiddleOf(std::size_t cell) const
  {
    const int cells = this->Map.GetCells();
    const int column = static_cast<int>(cell % this->Columns);
    const int row = static_cast<int>(cell / this->Columns);
    const double angle = 0.5 * WFV_PI / cells;
    const vec3 q(std::tan((column % cells + 0.5) * angle - 0.25 * WFV_PI),
      std::tan((row + 0.5) * angle - 0.25 * WFV_PI), 1);
    return glm::normalize(wfvFromFace(q, column / cells));
  }

  void Plant(int round)
  {
    std::vector<double> best(this->Seeds.size(), -2);
    for (std::size_t i = 0; i < this->Cells.size(); i++)
    {
      const int cell = this->Cells[i];
      if (cell < 0)
      {
        continue;
      }
      const vec2 pixel(i % this->Map.GetWidth(), i / this->Map.GetWidth());
      CellSeeds& seeds = this->Seeds[cell];
      const bool apart = std::all_of(seeds.begin(), seeds.begin() + round,
        [&](const vec2& s) { return s.x >= 0 && glm::distance(s, pixel) > SeedGap; });
      if (!apart)
      {
        continue;
      }
      const double near = glm::dot(this->MiddleOf(cell), DirectionOf(this->Map.GetDirections()[i]));
      if (near > best[cell])
      {
        best[cell] = near;
        seeds[round] = pixel;
      }
    }
  }

  // A cell without pixels takes the seeds of a neighbour in its row or column: between the
  // pixels of a coarse map, and beside its borders.
  void Spread()
  {
    for (int round = 0; round < SpreadRounds; round++)
    {
      const std::vector<CellSeeds> before = this->Seeds;
      for (std::size_t i = 0; i < before.size(); i++)
      {
        for (std::size_t j : { i - 1, i + 1, i - this->Columns, i + this->Columns })
        {
          if (this->Seeds[i][0].x < 0 && j < before.size())
          {
            this->Seeds[i] = before[j];
          }
        }
      }
    }
  }

  const DirectionMap& Map;
  int Columns;
  std::vector<int> Cells; // of each pixel
  std::vector<CellSeeds> Seeds;
};
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
  this->PlantSeeds();
}

void DirectionMap::MarkPixels()
{
  const int w = this->Width;
  const Steps right(this->Directions, w, this->Height, 1);
  const Steps up(this->Directions, w, this->Height, 0);
  const auto bend = [](double a, double b) {
    return a < 0 || b < 0 || std::abs(a - b) > CalmChange * std::min(a, b);
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
      bits |= right.Hangs(x, y) ? WFV_PIXEL_RIGHT : 0;
      bits |= right.Hangs(x - 1, y) ? WFV_PIXEL_LEFT : 0;
      bits |= up.Hangs(x, y) ? WFV_PIXEL_UP : 0;
      bits |= up.Hangs(x, y - 1) ? WFV_PIXEL_DOWN : 0;
      bits |= square(x, y) ? WFV_PIXEL_SQUARE : 0;
      const bool calm = square(x, y) && square(x - 1, y) && square(x, y - 1) &&
        square(x - 1, y - 1) && !bend(right.At(x, y), right.At(x - 1, y)) &&
        !bend(up.At(x, y), up.At(x, y - 1));
      texel[3] = static_cast<float>(calm ? bits | WFV_PIXEL_CALM : bits);
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

namespace
{
// Writes a level into its rows of the table.
void WriteLevel(const Level& level, int cells, std::vector<Texel>& table)
{
  for (int row = 0; row < level.Cells; row++)
  {
    for (int column = 0; column < 6 * level.Cells; column++)
    {
      const WfvPlaces& cell = level.At(column, row);
      const std::size_t line = level.Cells - WFV_COARSEST_CELLS + row;
      Texel* const texels = &table[2 * (line * 6 * cells + column)];
      texels[0] = TexelOf(cell.first);
      texels[1] = TexelOf(cell.second);
      texels[0][0] += cell.calm && cell.first.x <= 1 ? static_cast<float>(WFV_CALM_CELL) : 0.f;
    }
  }
}
}

// A cell has what lies in it and its neighbours, on its own level and all finer ones, and
// what of coarser ones lies round the cell that holds it.
void DirectionMap::BoundCells()
{
  const std::vector<Level> own = StorePixels(*this);
  std::vector<Level> whole = own;
  for (std::size_t l = whole.size() - 1; l > 1; l--)
  {
    UniteWithFiner(whole[l - 1], whole[l]);
  }
  Level coarser = own[0];
  this->CellBounds.assign(
    12 * static_cast<std::size_t>(this->Cells) * this->GetCellBoundsHeight(),
    TexelOf(wfvNoPlaces().first));
  for (std::size_t l = 1; l < own.size(); l++)
  {
    Level wide = Dilate(whole[l]);
    UniteWithCoarser(wide, coarser);
    WriteLevel(wide, this->Cells, this->CellBounds);
    Level next = Dilate(own[l]);
    UniteWithCoarser(next, coarser);
    coarser = next;
  }
}

void DirectionMap::PlantSeeds()
{
  this->Seeds = SeedBed(*this).GetTexels();
}
}
