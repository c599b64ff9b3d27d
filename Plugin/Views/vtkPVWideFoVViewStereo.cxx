// SPDX-License-Identifier: BSD-3-Clause
// vtkPVWideFoVView: two eyes.
#include "vtkPVWideFoVView.h"

#include "Stereo/Stereo.h"
#include "vtkPVWideFoVViewInternals.h"

#include "vtkRenderWindow.h"

#include <array>

namespace
{
using Numbers = std::array<double, 8>;

// Every number of every stereo model.
Numbers NumbersOf(vtkWideFoVCamera* camera)
{
  Numbers all{ { camera->GetInterpupillaryDistance(), camera->GetSeparation(),
    camera->GetConvergence(), 0, 0, 0, 0, 0 } };
  camera->GetPoleFade(&all[3]);
  camera->GetWarpedStereo(&all[5]);
  return all;
}
}

void vtkPVWideFoVView::SetStereoModel(const char* name)
{
  this->Internal->Stereo->SetStereoModel(name);
  this->UpdateCamera();
}

void vtkPVWideFoVView::SetInterpupillaryDistance(double distance)
{
  this->Internal->Stereo->SetInterpupillaryDistance(distance);
  this->UpdateCamera();
}

void vtkPVWideFoVView::SetPoleFade(double start, double end)
{
  this->Internal->Stereo->SetPoleFade(start, end);
  this->UpdateCamera();
}

void vtkPVWideFoVView::SetWarpedStereo(double iod, double distance, double offset)
{
  this->Internal->Stereo->SetWarpedStereo(iod, distance, offset);
  this->UpdateCamera();
}

void vtkPVWideFoVView::SetSeparation(double fraction)
{
  this->Internal->Stereo->SetSeparation(fraction);
  this->UpdateCamera();
}

void vtkPVWideFoVView::SetConvergence(double distance)
{
  this->Internal->Stereo->SetConvergence(distance);
  this->UpdateCamera();
}

void vtkPVWideFoVView::UpdateStereo()
{
  auto* camera = vtkWideFoVCamera::SafeDownCast(this->GetActiveCamera());
  vtkRenderWindow* const window = this->GetRenderWindow();
  if (!camera || !window)
  {
    return;
  }
  vtkWideFoVCamera* const from = this->Internal->Stereo;
  // one eye alone need not be drawn as if it were two
  camera->SetStereoModel(
    window->GetStereoRender() ? from->GetStereoModel() : wfv::NoStereo().Name.c_str());
  const Numbers now = NumbersOf(from);
  if (now == NumbersOf(camera))
  {
    return; // a camera that is set anew is a new one to whoever keeps what it has computed
  }
  camera->SetInterpupillaryDistance(now[0]);
  camera->SetSeparation(now[1]);
  camera->SetConvergence(now[2]);
  camera->SetPoleFade(now[3], now[4]);
  camera->SetWarpedStereo(now[5], now[6], now[7]);
}
