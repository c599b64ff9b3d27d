// SPDX-License-Identifier: BSD-3-Clause
// The eye that a hand turns: what is grabbed, orbited or flown past, for random poses.
#include "Viewing/Navigator.h"

#include "Scenes/MeshBuilder.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

using namespace widefov;

namespace
{
// TurnRounding of a few products of unit vectors, a hundred times over.
constexpr double TurnRounding = 1e-12;

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
  RC_ASSERT(std::abs(Dot(right, up)) < TurnRounding);
  RC_ASSERT(Dot(n.GetUp(), up) > -TurnRounding);
  RC_ASSERT(std::abs(Dot(n.GetDirection(), n.GetUp())) < TurnRounding);
  RC_ASSERT(std::abs(Dot(n.GetUp(), n.GetUp()) - 1) < TurnRounding);
}
}

RC_GTEST_PROP(Navigator, BeginsAsItIsTold, ())
{
  const Vector3 up = Direction();
  const Vector3 direction = Direction();
  const Navigator n({ { 1, 2, 3 } }, 5. * direction, up, 2. * up);
  RC_ASSERT(Apart(n.GetDirection(), direction) < TurnRounding);
  AssertUpright(n, up);
}

TEST(Navigator, BeginsStraightUpAndDown)
{
  for (const double sign : { 1., -1. })
  {
    const Vector3 head{ { 0, 0, sign } }; // as MakePose has it
    const Navigator n({ { 0, 0, 0 } }, { { 0, sign, 0 } }, head, { { 0, 1, 0 } });
    EXPECT_LT(Apart(n.GetDirection(), { { 0, sign, 0 } }), TurnRounding);
    EXPECT_LT(Apart(n.GetUp(), head), TurnRounding);
    EXPECT_NEAR(n.GetPitch(), 90 * sign, TurnRounding);
  }
}

// Whatever direction was shown there in another pose can be shown there again, but at the
// sides and beyond the zenith.
RC_GTEST_PROP(Navigator, ShowsTheDirectionGrabbedWhereThePointerIs, ())
{
  const Vector3 up = Direction();
  Navigator n = SomePose(up);
  const Vector3 view = Direction();
  const Vector3 ahead = Unit(n.GetDirection() - Dot(n.GetDirection(), up) * up);
  const Vector3 shown = n.ToWorld(view);
  RC_PRE(std::abs(Dot(shown, ahead)) > 0.51 * Apart(shown, Dot(shown, up) * up));
  Navigator other = n;
  other.Turn(Number(-180, 180), Number(-90, 90));
  Navigator::Grip grip = n.Grab(view);
  grip.World = other.ToWorld(view);
  n.Pull(grip, view);
  AssertUpright(n, up);
  RC_ASSERT(std::abs(n.GetPitch()) > 90 - PlaceRounding ||
    Apart(n.ToWorld(view), grip.World) < PlaceRounding);
}

// At the side too, whatever the latitude.
RC_GTEST_PROP(Navigator, TheAzimuthIsAlwaysRight, ())
{
  const Vector3 up{ { 0, 1, 0 } };
  Navigator n = SomePose(up);
  const Vector3 view = Direction();
  Navigator::Grip grip = n.Grab(view);
  grip.World = Direction();
  n.Pull(grip, view);
  AssertUpright(n, up);
  RC_ASSERT(std::abs(n.GetPitch()) <= 90 + TurnRounding);
  const Vector3 shown = n.ToWorld(view);
  const double a = std::atan2(shown[0], shown[2]) - std::atan2(grip.World[0], grip.World[2]);
  RC_PRE(std::hypot(shown[0], shown[2]) > 1e-3 && std::hypot(grip.World[0], grip.World[2]) > 1e-3);
  RC_ASSERT(std::abs(std::sin(0.5 * a)) < PlaceRounding);
}

// Small ways of the hand are small turns of the eye, whichever direction it holds: there is
// no side at which the view leaps.
RC_GTEST_PROP(Navigator, NothingLeaps, ())
{
  const Vector3 up{ { 0, 1, 0 } };
  Navigator n({ { 0, 0, 0 } }, { { Number(-1, 1), 0, -1 } }, up, up);
  const double longitude = Number(-3.14159, 3.14159);
  const double latitude = Number(-0.5, 0.5);
  const auto ray = [](double a, double b) {
    return Vector3{ { std::sin(a) * std::cos(b), std::sin(b), -std::cos(a) * std::cos(b) } };
  };
  const Navigator::Grip grip = n.Grab(ray(longitude, latitude));
  const double small = 0.01; // radians
  n.Pull(grip, ray(longitude + small, latitude + small));
  RC_ASSERT(std::abs(n.GetPitch()) < 3 * small * 57.3);
}

TEST(Navigator, ComingBackUndoesADrag)
{
  Navigator n({ { 0, 0, 0 } }, { { 1, 0.3, -1 } }, { { 0, 1, 0 } }, { { 0, 1, 0 } });
  const Vector3 start = Unit({ { 1, 0.2, -0.4 } });
  const Vector3 before = n.GetDirection();
  const Navigator::Grip grip = n.Grab(start);
  n.Pull(grip, Unit({ { 1, -0.9, 0.3 } }));
  EXPECT_GT(Apart(n.GetDirection(), before), 0.1);
  n.Pull(grip, start);
  EXPECT_LT(Apart(n.GetDirection(), before), TurnRounding);
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
