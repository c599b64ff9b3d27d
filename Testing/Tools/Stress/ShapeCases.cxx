// SPDX-License-Identifier: BSD-3-Clause
// Triangles of unfortunate shapes and numbers.
#include "Cases.h"
#include "Soup.h"

namespace wfv
{
namespace stress
{
namespace
{
// A point of the great circle from `from` towards `to` (unit, at right angles).
vec3 Along(const vec3& from, const vec3& to, double angle)
{
  return from * std::cos(angle) + to * std::sin(angle);
}

// Three points of an arc, the third beside it by `width` (radians).
Triangle Thin(Random& random, double length, double width, double third)
{
  const vec3 d = random.Direction();
  const std::array<vec3, 2> frame = FrameOf(d);
  const double turn = random.Between(0, 2 * WFV_PI);
  const vec3 ahead = frame[0] * std::cos(turn) + frame[1] * std::sin(turn);
  const vec3 aside = glm::cross(d, ahead);
  return { { d * random.Log(0.5, 20), Along(d, ahead, length) * random.Log(0.5, 20),
    (Along(d, ahead, third * length) + aside * width) * random.Log(0.5, 20) } };
}

// Without area: equal points, points in a line, or all in one.
Triangle Degenerate(Random& random)
{
  Triangle t =
    TriangleAround(random, random.Direction(), random.Log(0.01, 2), random.Between(0.5, 10));
  switch (random.Below(4))
  {
    case 0:
      t[1] = t[0];
      break;
    case 1:
      t[2] = t[0] = t[1];
      break;
    case 2:
      t[2] = t[0]; // a line back and forth
      break;
    default:
      // in float exactly in a line: the ends have few digits
      for (vec3& p : t)
      {
        p = vec3(std::round(p.x * 64), std::round(p.y * 64), std::round(p.z * 64)) / 64.0;
      }
      t[2] = (t[0] + t[1]) / 2.0;
  }
  return t;
}

// A number as float32 cannot hold it in full: from 1e-45 to the least normal.
double Denormal(Random& random)
{
  return random.Sign() * random.Log(1.5e-45, 1.1e-38);
}
}

Subject MakeNeedles(Random& random, int primitives)
{
  Soup soup;
  for (int i = 0; i < primitives; ++i)
  {
    soup.Add(Thin(random, random.Log(0.05, 3), random.Log(1e-5, 0.05), random.Between(0.95, 1.05)));
  }
  return { soup.Finish() };
}

Subject MakeSlivers(Random& random, int primitives)
{
  Soup soup;
  for (int i = 0; i < primitives; ++i)
  {
    soup.Add(Thin(random, random.Log(0.05, 2), random.Log(1e-6, 0.02), random.Between(0.1, 0.9)));
  }
  return { soup.Finish() };
}

Subject MakeZeroArea(Random& random, int primitives)
{
  Soup soup;
  for (int i = 0; i < primitives; ++i)
  {
    soup.Add(i % 2 == 0
        ? Degenerate(random)
        : TriangleAround(random, random.Direction(), random.Log(0.01, 0.3), random.Between(1, 10)));
  }
  return { soup.Finish() };
}

Subject MakeSignedZeros(Random& random, int primitives)
{
  const std::vector<double> values{ 0.0, -0.0, 0.0, -0.0, 1, -1, 2, -2, 0.5, -0.5, 3, -3 };
  Soup soup;
  for (int i = 0; i < primitives; ++i)
  {
    Triangle t;
    for (vec3& p : t)
    {
      p = vec3(random.Choose(values), random.Choose(values), random.Choose(values)) *
        random.Log(0.5, 8);
    }
    soup.Add(t);
  }
  return { soup.Finish() };
}

Subject MakeDenormals(Random& random, int primitives)
{
  Soup soup;
  for (int i = 0; i < primitives; ++i)
  {
    const double size = random.Log(0.01, 0.5);
    Triangle t = TriangleAround(random, random.Direction(), size, 0.5 + 16 * size);
    const bool all = random.Chance(0.1); // a triangle smaller than anything, at the eye
    for (vec3& p : t)
    {
      for (double* c : { &p.x, &p.y, &p.z })
      {
        *c = all || random.Chance(0.15) ? Denormal(random) : *c;
      }
    }
    soup.Add(t);
  }
  return { soup.Finish() };
}
}
}
