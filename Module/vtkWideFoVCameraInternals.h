// SPDX-License-Identifier: BSD-3-Clause
// What vtkWideFoVCamera keeps to itself.
#ifndef vtkWideFoVCameraInternals_h
#define vtkWideFoVCameraInternals_h

#include "Projections/Projection.h"
#include "vtkWideFoVCamera.h"

#include <optional>

struct vtkWideFoVCamera::Internals
{
  wfv::ViewOptions Options;
  std::optional<wfv::View> Cache;
  double CacheAspect = 0;
  wfv::Eye CacheEye = wfv::Eye::Middle;
  vtkMTimeType CacheTime = 0;
  bool ForBothEyes = false; // the frustum that is asked for
  vtkTimeStamp MatrixTime;
  vtkRenderer* MatrixRenderer = nullptr;
};

#endif
