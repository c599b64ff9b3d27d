// SPDX-License-Identifier: BSD-3-Clause
// Triangles of all sizes, scales and places.
#include "Cases.h"
#include "Soup.h"

namespace wfv
{
namespace stress
{
namespace
{
// Small ones stand in front of large ones, which would hide them.
double DistanceOf(Random& random, double size, double least, double most)
{
  const double share = std::log(size / least) / std::log(most / least);
  return 0.5 + 8 * share + random.Between(0, 1);
}

void AddSizes(Soup& soup, Random& random, int primitives, double least, double most,
  const vec3& centre, double scale)
{
  for (int i = 0; i < primitives; ++i)
  {
    const double size = random.Log(least, most);
    Triangle t =
      TriangleAround(random, random.Direction(), size, DistanceOf(random, size, least, most));
    for (vec3& p : t)
    {
      p = centre + p * scale;
    }
    soup.Add(t);
  }
}

constexpr double LeastSize = 0.005; // radians: a fifth of a pixel of a picture 256 wide
constexpr double MostSize = 0.5;
}

std::array<vec3, 2> FrameOf(const vec3& d)
{
  const vec3 other = std::abs(d.x) < 0.6 ? vec3(1, 0, 0) : vec3(0, 1, 0);
  const vec3 a = glm::normalize(glm::cross(d, other));
  return { { a, glm::cross(d, a) } };
}

Triangle TriangleAround(Random& random, const vec3& direction, double size, double distance)
{
  const std::array<vec3, 2> frame = FrameOf(direction);
  Triangle t;
  for (vec3& p : t)
  {
    const double a = random.Between(-1, 1);
    const double b = random.Between(-1, 1);
    p = (direction + (frame[0] * a + frame[1] * b) * size) * distance * random.Between(0.9, 1.1);
  }
  return t;
}

Subject MakeRandom(Random& random, int primitives)
{
  Soup soup;
  AddSizes(soup, random, primitives, LeastSize, MostSize, vec3(0), 1);
  return { soup.Finish() };
}

Subject MakeSmall(Random& random, int primitives)
{
  Soup soup;
  AddSizes(soup, random, primitives, 0.002, 0.05, vec3(0), 1);
  return { soup.Finish() };
}

Subject MakeLarge(Random& random, int primitives)
{
  Soup soup;
  for (int i = 0; i < primitives; ++i)
  {
    Triangle t;
    for (vec3& p : t)
    {
      p = random.Direction() * random.Log(1, 20);
    }
    soup.Add(t);
  }
  return { soup.Finish() };
}

Subject MakeScales(Random& random, int primitives)
{
  Soup soup;
  const double scale = random.Log(1e-6, 1e8);
  AddSizes(soup, random, primitives, LeastSize, MostSize, vec3(0), scale);
  return { soup.Finish(), vec3(0), 0.05 * scale, 50 * scale };
}

Subject MakeOffsets(Random& random, int primitives)
{
  Soup soup(random.Chance(0.5)); // as float, the points lie on a grid of 1/128
  const vec3 centre = vec3(random.Sign(), random.Sign(), random.Sign()) * 1e5;
  AddSizes(soup, random, primitives, 0.03, MostSize, centre, 1);
  return { soup.Finish(), centre };
}
}
}
