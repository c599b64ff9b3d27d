// SPDX-License-Identifier: BSD-3-Clause
#include "Stereo/Comfort.h"

#include "Stereo/Stereo.h"

#include <algorithm>
#include <cmath>

namespace wfv
{
namespace
{
// Metres: between people's eyes, and from them to what is near.
constexpr double EyeDistance = 0.065;
constexpr double PleasantlyNear = 0.75;
constexpr double TooNear = 0.5;

// Times the convergence.
constexpr double NearestContent = 0.5;
constexpr double FarthestContent = 100;

// Of the picture, at either end of its distances: a leaf before the lens decides nothing.
constexpr double LeftOut = 0.01;
}

double Parallax(double separation, double convergence, double w)
{
  return 100 * separation * (1 - convergence / w);
}

double CircleDisparity(double interpupillaryDistance, double d)
{
  const double sine = 0.5 * interpupillaryDistance / d;
  return sine < 1 ? 2 * glm::degrees(std::asin(sine)) : 180;
}

double ParallaxAngle(double percent, double screenWidth, double viewerDistance)
{
  return 2 * glm::degrees(std::atan2(0.005 * percent * screenWidth, viewerDistance));
}

double ComfortableEyeDistance(double nearest)
{
  return nearest * EyeDistance / PleasantlyNear;
}

double LargestDisparity()
{
  return CircleDisparity(EyeDistance, TooNear);
}

std::array<double, 2> DepthBudget(double convergence)
{
  return { { NearestContent * convergence, FarthestContent * convergence } };
}

double Quantile(std::vector<double>& values, double part)
{
  if (values.empty())
  {
    return 0;
  }
  const auto last = static_cast<double>(values.size() - 1);
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(std::lround(part * last));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

double ConvergenceFor(std::vector<double> distances)
{
  const double nearest = Quantile(distances, LeftOut);
  const double farthest = Quantile(distances, 1 - LeftOut);
  const double least = farthest / FarthestContent;
  const double most = nearest / NearestContent;
  return std::min(most, std::max(least, Quantile(distances, 0.5)));
}

double LargestSeparation(double screenWidth, double eyeDistance)
{
  return std::clamp(eyeDistance / screenWidth, 0.0, MostSeparation);
}
}
