// SPDX-License-Identifier: BSD-3-Clause
#include "Comfort.h"

#include <algorithm>
#include <cmath>

namespace wfv
{
namespace
{
const double Degree = WFV_PI / 180;

// Times the convergence.
constexpr double NearestContent = 0.5;
constexpr double FarthestContent = 100;

// Fraction of the width: the largest that the camera takes.
constexpr double MostSeparation = 0.5;
}

double OffAxisParallax(double separation, double convergence, double w)
{
  return 100 * separation * (1 - convergence / w);
}

double OmnidirectionalDisparity(double interpupillaryDistance, double d)
{
  const double sine = 0.5 * interpupillaryDistance / d;
  return sine < 1 ? 2 * std::asin(sine) / Degree : 180;
}

double ParallaxAngle(double percent, double screenWidth, double viewerDistance)
{
  return 2 * std::atan2(0.005 * percent * screenWidth, viewerDistance) / Degree;
}

std::array<double, 2> DepthBudget(double convergence)
{
  return { { NearestContent * convergence, FarthestContent * convergence } };
}

double LargestSeparation(double screenWidth, double eyeDistance)
{
  return std::clamp(eyeDistance / screenWidth, 0.0, MostSeparation);
}
}
