// SPDX-License-Identifier: BSD-3-Clause
// What a vtkPVWideFoVView keeps; for its own sources alone.
#ifndef vtkPVWideFoVViewInternals_h
#define vtkPVWideFoVViewInternals_h

#include "vtkPVWideFoVView.h"

#include "FrameThreads.h"
#include "SceneTexts.h"
#include "StandIns.h"
#include "UndrawnProps.h"
#include "vtkWideFoVCamera.h"
#include "vtkWideFoVEverywhereProp.h"
#include "vtkWideFoVPass.h"
#include "vtkWideFoVReducedPass.h"

#include "vtkNew.h"
#include "vtkPVDefaultPass.h"

#include <array>
#include <memory>
#include <string>

struct vtkPVWideFoVView::Internals
{
  vtkNew<vtkWideFoVPass> Pass;
  vtkNew<vtkPVDefaultPass> Delegate;
  vtkNew<vtkWideFoVReducedPass> Reduced; // round the pass
  vtkNew<vtkWideFoVEverywhereProp> Everywhere;
  std::string Projection = "equirectangular";
  double HorizontalFov = 360;
  double VerticalFov = 180;
  double Tilt = 0;
  std::array<double, 5> Lens{ { 0, 0, 0, 0, 0 } };
  std::string DirectionMapFile;
  std::shared_ptr<const wfv::DirectionMap> DirectionMap; // none without a file
  bool AutomaticClipSpheres = true;
  std::array<double, 2> ClipSpheres{ { 0.01, 1000 } };
  int DepthMapping = vtkWideFoVCamera::LINEAR;
  bool DataDrawn = false; // by any frame yet
  wfvplugin::UndrawnProps Undrawn;
  wfvplugin::StandIns Instead;
  wfvplugin::SceneTexts Texts;
  wfvplugin::FrameThreads Threads;

  // Its stereo settings alone count: a camera knows which values are none.
  vtkNew<vtkWideFoVCamera> Stereo;
};

#endif
