// SPDX-License-Identifier: BSD-3-Clause
// vtkWideFoVStage: what it does for volumes.
#include "Frame/vtkWideFoVStage.h"

#include "Compat/StockText.h"
#include "Drawables/Volumes.h"
#include "Frame/Stages.h"

#include "vtkAbstractMapper.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkVolume.h"

bool vtkWideFoVStage::FinishVolume(vtkProp* prop, vtkAbstractMapper* mapper, std::string& vertex,
  std::string& geometry, std::string& fragment) const
{
  auto* const volume = vtkVolume::SafeDownCast(prop);
  if (!volume)
  {
    return false;
  }
  wfv::ShaderBuilder::Request request = this->MakeRayRequest();
  request.View.Multisample = false; // a pixel's volume has one ray in any case
  wfv::volume::Finish(request, wfv::volume::Describe(this->Renderer, volume), geometry, fragment);
  wfv::stock::LeaveOutUnedited(this->Renderer, mapper, vertex, geometry, fragment);
  return true;
}

void vtkWideFoVStage::SetVolumeParameters(vtkShaderProgram* program, vtkProp* prop) const
{
  auto* const volume = vtkVolume::SafeDownCast(prop);
  if (!volume)
  {
    return;
  }
  const double* const bounds = volume->GetBounds();
  wfv::volume::SetCover(program, this->Stages->GetPictures(bounds), this->Pixels.Full);
  if (program->IsUniformUsed("wfvVolumeRange"))
  {
    const wfv::vec2 distances = this->Stages->GetDistances(bounds);
    const float range[2] = { static_cast<float>(distances.x), static_cast<float>(distances.y) };
    program->SetUniform2f("wfvVolumeRange", range);
  }
}
