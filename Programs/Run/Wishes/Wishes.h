// SPDX-License-Identifier: BSD-3-Clause
// What a program that knows nothing of wide views is to show: options of widefov-run, which reach
// the program as variables of its environment.
#ifndef WideFoVWishes_h
#define WideFoVWishes_h

#include "Stereo/Stereo.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace widefov
{
struct Wishes
{
  std::string Projection = "equirectangular";
  const wfv::StereoModel* Stereo = &wfv::NoStereo();
  std::optional<double> HorizontalFov, VerticalFov, Fov, Tilt; // degrees
  std::optional<double> EyeDistance;                           // scene units
  bool Inside = false;                                         // the eye is at the focal point

  // Whether stock VTK's camera serves.
  bool IsFlat() const { return this->Projection == "perspective" && !this->Stereo->Traits.TwoEyes; }
};

// One of the options, under both of its names.
struct Wish
{
  const char* Option;
  const char* Variable;
  const char* Type; // of its value; "" for a flag, whose variable is 1
  const char* Text;
  void (*Take)(Wishes& wishes, const std::string& name, const std::string& value);
};
const std::vector<Wish>& AllWishes();

// The value of a wish, nothing where it was not given. The name is for messages.
using Given = std::function<std::optional<std::string>(const Wish&)>;

// Throws a Failure with ExitUsage that names what is wrong.
Wishes ReadWishes(const Given& given, const char* Wish::*name);
}

#endif
