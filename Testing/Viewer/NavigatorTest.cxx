// SPDX-License-Identifier: BSD-3-Clause
// The eye that a hand turns: what is grabbed, orbited or flown past, for random poses.
#include "Navigator.h"

#include "MeshBuilder.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

using namespace widefov;

namespace
{
// Rounding of a few products of unit vectors, a hundred times over.
constexpr double Rounding = 1e-12;

// Unit vectors, and what is built on differences of places about 100 large.
constexpr double PlaceRounding = 1e-9;

double Number(double low, double high)
{
  return low + (high - low) * (*rc::gen::inRange(0, 1000001)) * 1e-6;
}

Vector3 Direction()
{
  const double z = Number(-1, 1);
  const double a = Number(-3.14159, 3.14159);
  const double r = std::sqrt(1 - z * z);
  return { { r * std::cos(a), r * std::sin(a), z } };
}

double Dot(const Vector3& a, const Vector3& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

double Apart(const Vector3& a, const Vector3& b)
{
  const Vector3 d = a - b;
  return std::sqrt(Dot(d, d));
}

Navigator SomePose(const Vector3& up)
{
  const Vector3 eye = 100. * Direction();
  return Navigator(eye, 3. * Direction(), Direction(), up);
}

void AssertUpright(const Navigator& n, const Vector3& up)
{
  const Vector3 right = Cross(n.GetDirection(), n.GetUp());
  RC_ASSERT(std::abs(Dot(right, up)) < Rounding);
  RC_ASSERT(Dot(n.GetUp(), up) > -Rounding);
  RC_ASSERT(std::abs(Dot(n.GetDirection(), n.GetUp())) < Rounding);
  RC_ASSERT(std::abs(Dot(n.GetUp(), n.GetUp()) - 1) < Rounding);
}
}

RC_GTEST_PROP(Navigator, BeginsAsItIsTold, ())
{
  const Vector3 up = Direction();
  const Vector3 direction = Direction();
  const Navigator n({ { 1, 2, 3 } }, 5. * direction, up, 2. * up);
  RC_ASSERT(Apart(n.GetDirection(), direction) < Rounding);
  AssertUpright(n, up);
}

TEST(Navigator, BeginsStraightUpAndDown)
{
  for (const double sign : { 1., -1. })
  {
    const Vector3 head{ { 0, 0, sign } }; // as MakePose has it
    const Navigator n({ { 0, 0, 0 } }, { { 0, sign, 0 } }, head, { { 0, 1, 0 } });
    EXPECT_LT(Apart(n.GetDirection(), { { 0, sign, 0 } }), Rounding);
    EXPECT_LT(Apart(n.GetUp(), head), Rounding);
    EXPECT_NEAR(n.GetPitch(), 90 * sign, Rounding);
  }
}

// Whatever direction was shown there in another pose can be shown there again.
RC_GTEST_PROP(Navigator, ShowsTheDirectionGrabbedWhereThePointerIs, ())
{
  const Vector3 up = Direction();
  Navigator n = SomePose(up);
  const Vector3 view = Direction();
  Navigator other = n;
  other.Turn(Number(-180, 180), Number(-90, 90));
  const Vector3 world = other.ToWorld(view);
  n.Face(view, world);
  RC_ASSERT(Apart(n.ToWorld(view), world) < PlaceRounding);
  AssertUpright(n, up);
}

// And one that cannot: the horizon stays, and the azimuth is right.
RC_GTEST_PROP(Navigator, ComesAsNearAsTheHorizonAllows, ())
{
  const Vector3 up{ { 0, 1, 0 } };
  Navigator n = SomePose(up);
  const Vector3 view = Direction();
  const Vector3 world = Direction();
  n.Face(view, world);
  AssertUpright(n, up);
  RC_ASSERT(std::abs(n.GetPitch()) <= 90 + Rounding);
  const Vector3 shown = n.ToWorld(view);
  const double a = std::atan2(shown[0], shown[2]) - std::atan2(world[0], world[2]);
  RC_PRE(std::hypot(shown[0], shown[2]) > 1e-3 && std::hypot(world[0], world[2]) > 1e-3);
  RC_ASSERT(std::abs(std::sin(0.5 * a)) < PlaceRounding);
}

RC_GTEST_PROP(Navigator, OrbitKeepsTheCentreInThePicture, ())
{
  Navigator n = SomePose({ { 0, 0, 1 } });
  const Vector3 center = 100. * Direction();
  const auto inView = [&] {
    const Vector3 away = center - n.GetEye();
    return Vector3{ { Dot(away, Cross(n.GetDirection(), n.GetUp())), Dot(away, n.GetUp()),
      Dot(away, n.GetDirection()) } };
  };
  const Vector3 before = inView();
  n.Orbit(center, Number(-400, 400), Number(-200, 200));
  RC_ASSERT(Apart(inView(), before) < PlaceRounding);
}

RC_GTEST_PROP(Navigator, FliesWhereItLooks, ())
{
  const Vector3 up = Direction();
  Navigator n = SomePose(up);
  const Vector3 eye = n.GetEye();
  n.Fly(2, 3, 5);
  const Vector3 right = Cross(n.GetDirection(), n.GetUp());
  const Vector3 expected = eye + 2. * right + 3. * up + 5. * n.GetDirection();
  RC_ASSERT(Apart(n.GetEye(), expected) < PlaceRounding);
}
