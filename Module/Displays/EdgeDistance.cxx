// SPDX-License-Identifier: BSD-3-Clause
// Source: P. Felzenszwalb, D. Huttenlocher, "Distance Transforms of Sampled Functions", 2012.
#include "EdgeDistance.h"

#include <algorithm>

namespace wfv::displays
{
namespace
{
// Heights of the picture from a pixel that shows nothing to where its influence is half gone.
constexpr double HoleRamp = 0.1;

// Square pixels: beyond any picture.
constexpr float Far = 1e12f;

// The squares of distances along one line, from those across it: the lower envelope of parabolas.
class Envelope
{
public:
  explicit Envelope(int longest)
    : Values(longest)
    , Places(longest)
    , Starts(longest + 1)
  {
  }

  void Apply(float* line, int count, std::size_t stride)
  {
    int last = 0;
    for (int i = 0; i < count; i++)
    {
      this->Values[i] = line[i * stride];
    }
    this->Places[0] = 0;
    this->Starts[0] = -Far;
    for (int i = 1; i < count; i++)
    {
      double start = this->Meet(this->Places[last], i);
      while (last > 0 && start <= this->Starts[last])
      {
        start = this->Meet(this->Places[--last], i);
      }
      last++;
      this->Places[last] = i;
      this->Starts[last] = start;
    }
    int k = 0;
    for (int i = 0; i < count; i++)
    {
      while (k < last && this->Starts[k + 1] < i)
      {
        k++;
      }
      const double away = i - this->Places[k];
      line[i * stride] = static_cast<float>(away * away + this->Values[this->Places[k]]);
    }
  }

private:
  // Returns the abscissa from which the parabola of place b is below the parabola of place a.
  double Meet(int a, int b) const
  {
    const double left = this->Values[a] + double(a) * a;
    const double right = this->Values[b] + double(b) * b;
    return (right - left) / (2. * (b - a));
  }

  std::vector<double> Values;
  std::vector<int> Places;
  std::vector<double> Starts;
};
}

EdgeDistance::EdgeDistance(const Table& table)
  : Width(table.Width)
  , Height(table.Height)
{
  this->Distances.reserve(table.Count());
  for (const vec3& value : table.Values)
  {
    this->Distances.push_back(std::isnan(value.x) ? 0 : Far);
  }
  const std::size_t stride = this->Width;
  Envelope envelope(std::max(this->Width, this->Height));
  for (int x = 0; x < this->Width; x++)
  {
    envelope.Apply(&this->Distances[x], this->Height, stride);
  }
  for (int y = 0; y < this->Height; y++)
  {
    envelope.Apply(&this->Distances[y * stride], this->Width, 1);
  }
  for (float& distance : this->Distances)
  {
    distance = std::sqrt(distance);
  }
}

double EdgeDistance::At(double x, double y) const
{
  // 0 at the centres of the first pixels outside. Together they are the nearer one beside a border,
  // but have no ridge where both are alike, which pixels of other projectors would miss.
  const double u = std::clamp((x + 1) / (this->Width + 1), 0., 1.);
  const double v = std::clamp((y + 1) / (this->Height + 1), 0., 1.);
  const double across = 4 * u * (1 - u) * this->Width / this->Height;
  const double up = 4 * v * (1 - v);
  const double fromBorders = across * up / std::max(1e-12, std::hypot(across, up));
  const int x0 = std::clamp(static_cast<int>(x), 0, this->Width - 2);
  const int y0 = std::clamp(static_cast<int>(y), 0, this->Height - 2);
  const float* const at = &this->Distances[static_cast<std::size_t>(y0) * this->Width + x0];
  const double a = std::clamp(x - x0, 0., 1.);
  const double b = std::clamp(y - y0, 0., 1.);
  const double lower = glm::mix(double(at[0]), double(at[1]), a);
  const double upper = glm::mix(double(at[this->Width]), double(at[this->Width + 1]), a);
  const double fromHoles = glm::mix(lower, upper, b) / (HoleRamp * this->Height);
  return fromBorders * fromHoles * fromHoles / (1 + fromHoles * fromHoles);
}
}
