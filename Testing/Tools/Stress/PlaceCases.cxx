// SPDX-License-Identifier: BSD-3-Clause
// Triangles at the places where projections tear: the seam, the poles, the antipode and
// the eye. The view looks along -z with y up, so that zeros are exact.
#include "Cases.h"
#include "Soup.h"

namespace wfv
{
namespace stress
{
namespace
{
// Zero of either sign, or next to it.
double AboutZero(Random& random)
{
  const std::vector<double> steps{ 0, 0, 0, 1e-40, 1e-30, 1e-12, 1e-8, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3,
    1e-2 };
  return random.Sign() * random.Choose(steps);
}

// On the half plane x = 0, z > 0, or next to it.
vec3 SeamPoint(Random& random)
{
  const double phi = random.Between(-0.5, 0.5) * WFV_PI;
  return vec3(AboutZero(random), std::sin(phi), std::cos(phi)) * random.Between(0.8, 1.2);
}

// On an axis, or next to it: a pole, the antipode, or straight ahead.
vec3 AxisPoint(Random& random, int axis, double sign)
{
  vec3 p(AboutZero(random), AboutZero(random), AboutZero(random));
  p[axis] = sign * random.Between(0.8, 1.2);
  return p;
}

vec3 Near(Random& random, const vec3& p, double size)
{
  return p + random.Direction() * size;
}

// One that touches the axis: with a vertex on it, an edge through it, or inside.
Triangle AtAxis(Random& random, int axis, double sign, double size)
{
  const vec3 a = AxisPoint(random, axis, sign);
  Triangle t{ { a, Near(random, a, size), Near(random, a, size) } };
  if (random.Chance(0.3))
  {
    t[1] = AxisPoint(random, axis, sign);
  }
  if (random.Chance(0.4))
  {
    // the axis lies on the edge from 0 to 1, or inside where 2 is opposite to both
    vec3 away = random.Direction() * size;
    away[axis] = 0;
    vec3 on(0);
    on[axis] = a[axis];
    t[0] = on + away;
    t[1] = on - away;
    t[2] = Near(random, on, size);
  }
  return t;
}

// Through the eye, or past it by less than anything.
Triangle AtEye(Random& random)
{
  Triangle t;
  for (vec3& p : t)
  {
    p = random.Direction() * random.Log(0.2, 10);
  }
  const double miss = random.Choose(std::vector<double>{ 0, 0, 1e-40, 1e-20, 1e-7, 1e-5, 1e-3 });
  switch (random.Below(5))
  {
    case 0:
      t[0] = random.Direction() * miss; // a vertex at the eye
      break;
    case 1:
      t[1] = t[0] * -random.Log(0.1, 10) + random.Direction() * miss; // an edge
      break;
    case 2:
      t[2] = -(t[0] + t[1]) + random.Direction() * miss; // the face
      break;
    case 3:
      t[2] = t[0] * random.Between(-2, 2) + t[1] * random.Between(-2, 2) +
        random.Direction() * miss; // seen edge-on
      break;
    default:
      for (vec3& p : t)
      {
        p = p * random.Log(0.01, 0.1); // near and inside the near sphere
      }
  }
  return t;
}
}

Subject MakeSeams(Random& random, int primitives)
{
  Soup soup;
  for (int i = 0; i < primitives; ++i)
  {
    const double size = random.Log(0.01, 0.5);
    const double far = 1 + 16 * size;
    const vec3 a = SeamPoint(random);
    Triangle t{ { a, Near(random, a, size), Near(random, a, size) } };
    t[1] = random.Chance(0.5) ? SeamPoint(random) : t[1];
    t[2] = random.Chance(0.1) ? SeamPoint(random) : t[2];
    for (vec3& p : t)
    {
      p = p * far;
    }
    soup.Add(t);
  }
  return { soup.Finish() };
}

Subject MakePoles(Random& random, int primitives)
{
  Soup soup;
  for (int i = 0; i < primitives; ++i)
  {
    const double size = random.Log(0.01, 0.8);
    Triangle t = AtAxis(random, random.Chance(0.7) ? 1 : 2, random.Sign(), size);
    for (vec3& p : t)
    {
      p = p * (1 + 8 * size);
    }
    soup.Add(t);
  }
  return { soup.Finish() };
}

Subject MakeEye(Random& random, int primitives)
{
  Soup soup;
  for (int i = 0; i < primitives; ++i)
  {
    soup.Add(AtEye(random));
  }
  return { soup.Finish() };
}
}
}
