// SPDX-License-Identifier: BSD-3-Clause
// What vtkWideFoVCamera keeps to itself.
#ifndef WideFoVCameraInternals_h
#define WideFoVCameraInternals_h

#include "Projections/Projection.h"
#include "vtkWideFoVCamera.h"

#include <array>
#include <optional>

// Smallest field of view, degrees: below it float32 cannot tell pixels apart.
constexpr double MinFieldOfView = 0.01;

namespace wfv
{
// As if no camera had said yet what it ignores: for tests.
WFV_EXPORT void ForgetWhatIsIgnored();
}

struct vtkWideFoVCamera::Internals
{
  wfv::ViewOptions Options;
  std::optional<wfv::View> Cache;
  double CacheAspect = 0;
  wfv::Eye CacheEye = wfv::Eye::Middle;
  vtkMTimeType CacheTime = 0;
  bool InFrame = false;           // everything is prepared
  const double* Bounds = nullptr; // of the visible props, where they are known
  bool ForBothEyes = false;       // the frustum that is asked for
  // Normalized device coordinates that the window shows of a perspective: low and high x, low
  // and high y; all of it unless the window is a tile.
  std::array<double, 4> Part{ { -1, 1, -1, 1 } };
};

#endif
