// SPDX-License-Identifier: BSD-3-Clause
#include "RunRenderer.h"

#include "Camera/ActiveCamera.h"

#include <vtkMath.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkTransform.h>

#include <cmath>

namespace widefov
{
RunCamera* RunCamera::New()
{
  auto* const made = new RunCamera;
  made->InitializeObjectBase();
  return made;
}

RunCamera::RunCamera()
{
  const Wishes& wishes = TheWishes();
  this->SetProjection(wishes.Projection.c_str());
  this->SetStereoModel(wishes.Stereo->Name.c_str());
  this->SetInterpupillaryDistance(wishes.EyeDistance.value_or(this->GetInterpupillaryDistance()));
  this->SetHorizontalFieldOfView(wishes.HorizontalFov.value_or(this->GetHorizontalFieldOfView()));
  this->SetVerticalFieldOfView(wishes.VerticalFov.value_or(this->GetVerticalFieldOfView()));
  this->SetTilt(wishes.Tilt.value_or(this->GetTilt()));
  if (wishes.Fov)
  {
    this->SetFieldOfView(*wishes.Fov);
  }
  this->ComputeViewTransform(); // that of this class
}

void RunCamera::ComputeViewTransform()
{
  this->vtkWideFoVCamera::ComputeViewTransform();
  if (!TheWishes().Inside)
  {
    return;
  }
  vtkNew<vtkMatrix4x4> matrix;
  matrix->DeepCopy(this->ViewTransform->GetMatrix());
  const double ahead = std::sqrt(vtkMath::Distance2BetweenPoints(this->Position, this->FocalPoint));
  matrix->SetElement(2, 3, matrix->GetElement(2, 3) + ahead);
  this->ViewTransform->SetMatrix(matrix);
}

void RunCamera::GetViewpoint(double world[3])
{
  TheWishes().Inside ? this->GetFocalPoint(world) : this->vtkWideFoVCamera::GetViewpoint(world);
}

RunRenderer* RunRenderer::New()
{
  auto* const made = new RunRenderer;
  made->InitializeObjectBase();
  return made;
}

RunRenderer::RunRenderer()
{
  if (TheWishes().IsFlat())
  {
    this->SetPass(nullptr); // as stock VTK's
  }
}

vtkCamera* RunRenderer::MakeCamera()
{
  return this->vtkRenderer::MakeCamera();
}

void RunRenderer::DrawFlat()
{
  vtkNew<vtkOpenGLCamera> flat;
  flat->SetPosition(this->ActiveCamera->GetPosition());
  flat->SetFocalPoint(this->ActiveCamera->GetFocalPoint());
  flat->SetViewUp(this->ActiveCamera->GetViewUp());
  flat->SetParallelProjection(this->ActiveCamera->GetParallelProjection());
  flat->SetParallelScale(this->ActiveCamera->GetParallelScale());
  const wfv::ActiveCamera active(this, flat);
  this->ResetCameraClippingRange();
  this->vtkOpenGLRenderer::DeviceRender();
}

void RunRenderer::DeviceRender()
{
  if (TheWishes().IsFlat())
  {
    this->vtkOpenGLRenderer::DeviceRender();
  }
  else if (!this->Interactive && this->GetWideCamera())
  {
    this->DrawFlat();
  }
  else
  {
    this->vtkWideFoVRenderer::DeviceRender();
  }
}
}
