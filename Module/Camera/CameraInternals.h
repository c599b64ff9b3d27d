// SPDX-License-Identifier: BSD-3-Clause
// What vtkWideFoVCamera keeps to itself.
#ifndef WideFoVCameraInternals_h
#define WideFoVCameraInternals_h

#include "Camera/FlatQuestions.h"
#include "Camera/NearThings.h"
#include "Camera/Reach.h"
#include "Projections/Projection.h"
#include "vtkWideFoVCamera.h"

#include <array>
#include <optional>
#include <vector>

// Smallest field of view, degrees: below it float32 cannot tell pixels apart.
constexpr double MinFieldOfView = 0.01;

struct vtkWideFoVCamera::Internals
{
  // Of all cameras: a screenshot is drawn by a copy, and props ask the one that they were told of.
  static thread_local int FramesInDrawing;

  wfv::ViewOptions Options;
  double Turn = 0; // of the current eye about the vertical, radians
  std::optional<wfv::View> Cache;
  double CacheAspect = 0;
  wfv::Eye CacheEye = wfv::Eye::Middle;
  vtkMTimeType CacheTime = 0;
  bool InFrame = false;                       // everything is prepared
  const double* Bounds = nullptr;             // of the visible props, where they are known
  bool Staged = false;                        // the next matrices are for a draw that has a stage
  bool NothingBehind = false;                 // there is no plane that something could be behind
  int FlatDraws = 0;                          // that had none, since somebody asked
  std::array<int, 2> Framebuffer{ { 0, 0 } }; // of a pass that is drawn to; 0: the window's part
  bool ForBothEyes = false;                   // the frustum that is asked for
  // Normalized device coordinates that the window shows of a perspective: low and high x, low
  // and high y; all of it unless the window is a tile.
  std::array<double, 4> Part{ { -1, 1, -1, 1 } };
  wfv::NearThings Things;
  std::vector<vtkRenderer*> Sharing; // the depth of the renderer whose frame is prepared
  wfv::FlatQuestions Questions;
  std::array<double, 2> PickRange; // of the last picker
};

#endif
