// SPDX-License-Identifier: BSD-3-Clause
// vtkWideFoVCamera: two eyes.
#include "vtkWideFoVCamera.h"

#include "Camera/CameraInternals.h"
#include "Camera/Tile.h"
#include "Compat/Reports.h"
#include "Stereo/Comfort.h"
#include "Stereo/Stereo.h"

#include "vtkFloatArray.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPerspectiveTransform.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTransform.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace
{
// NaN becomes the low end; said by a warning.
double Clamp(vtkObject* self, const char* what, double value, double low, double high)
{
  const double clamped = std::isnan(value) ? low : std::clamp(value, low, high);
  if (clamped != value)
  {
    vtkWarningWithObjectMacro(self, << what << " " << value << " is outside [" << low << ", "
                                    << high << "]; " << clamped << " is used");
  }
  return clamped;
}

// NDC depths of what the last frame shows in the renderer's viewport.
std::vector<double> SeenDepths(vtkRenderer* renderer)
{
  int size[2];
  int origin[2];
  renderer->GetTiledSizeAndOrigin(&size[0], &size[1], &origin[0], &origin[1]);
  vtkNew<vtkFloatArray> depths;
  renderer->GetRenderWindow()->GetZbufferData(
    origin[0], origin[1], origin[0] + size[0] - 1, origin[1] + size[1] - 1, depths);
  std::vector<double> seen;
  for (vtkIdType i = 0; i < depths->GetNumberOfValues(); i++)
  {
    const double z = depths->GetValue(i);
    if (z > 0 && z < 1)
    {
      seen.push_back(2 * z - 1);
    }
  }
  return seen;
}
}

void vtkWideFoVCamera::SetStereoModel(const char* name)
{
  const wfv::StereoModel* const found = name ? wfv::FindStereoModel(name) : nullptr;
  if (!found)
  {
    std::string known;
    for (const wfv::StereoModel& m : wfv::StereoModels())
    {
      known += " " + m.Name;
    }
    vtkErrorMacro(<< "No stereo model is named " << (name ? name : "(null)") << "; there are"
                  << known);
    return;
  }
  if (found != this->Internal->Options.Stereo.Model)
  {
    this->Internal->Options.Stereo.Model = found;
    this->Modified();
  }
}

const char* vtkWideFoVCamera::GetStereoModel()
{
  const wfv::StereoModel* const model = this->Internal->Options.Stereo.Model;
  return model ? model->Name.c_str() : wfv::NoStereo().Name.c_str();
}

int vtkWideFoVCamera::GetNumberOfStereoModels()
{
  return static_cast<int>(wfv::StereoModels().size());
}

const char* vtkWideFoVCamera::GetStereoModelName(int index)
{
  const bool known = index >= 0 && index < vtkWideFoVCamera::GetNumberOfStereoModels();
  return known ? wfv::StereoModels()[index].Name.c_str() : nullptr;
}

bool vtkWideFoVCamera::SetStereoOptions(
  const wfv::StereoModel& model, const wfv::StereoOptions& options)
{
  // of a projection that the model is for: the options alone are asked about
  const wfv::Projection* const fitting =
    wfv::FindProjection(model.Traits.Flat ? "perspective" : "equirectangular");
  const std::string problem = model.Check(options, *fitting);
  if (!problem.empty())
  {
    vtkErrorMacro(<< problem << "; it is unchanged");
    return false;
  }
  this->Internal->Options.Stereo = options;
  this->Modified();
  return true;
}

void vtkWideFoVCamera::SetInterpupillaryDistance(double distance)
{
  const double v =
    Clamp(this, "The interpupillary distance", distance, 0, std::numeric_limits<float>::max());
  if (v != this->Internal->Options.Stereo.InterpupillaryDistance)
  {
    this->Internal->Options.Stereo.InterpupillaryDistance = v;
    this->Modified();
  }
}

double vtkWideFoVCamera::GetInterpupillaryDistance()
{
  return this->Internal->Options.Stereo.InterpupillaryDistance;
}

void vtkWideFoVCamera::SetPoleFade(double start, double end)
{
  wfv::StereoOptions options = this->Internal->Options.Stereo;
  options.PoleFade = { { start, end } };
  this->SetStereoOptions(wfv::StereoWith(wfv::StereoNumber::PoleFade), options);
}

void vtkWideFoVCamera::GetPoleFade(double latitudes[2])
{
  std::copy_n(this->Internal->Options.Stereo.PoleFade.begin(), 2, latitudes);
}

void vtkWideFoVCamera::SetCircleConvergence(double distance)
{
  wfv::StereoOptions options = this->Internal->Options.Stereo;
  options.CircleConvergence = distance;
  this->SetStereoOptions(wfv::StereoWith(wfv::StereoNumber::CircleConvergence), options);
}

double vtkWideFoVCamera::GetCircleConvergence()
{
  return this->Internal->Options.Stereo.CircleConvergence;
}

void vtkWideFoVCamera::Modified()
{
  wfv::StereoOptions options = this->Internal->Options.Stereo;
  options.Model = this->GetFittingModel();
  options.Eye = static_cast<wfv::Eye>(this->GetCurrentEye());
  const double turn = wfv::EyeTurn(options);
  if (turn != this->Internal->Turn)
  {
    this->Internal->Turn = turn;
    this->ComputeViewTransform();
  }
  this->Superclass::Modified();
}

void vtkWideFoVCamera::ComputeViewTransform()
{
  this->Superclass::ComputeViewTransform();
  if (this->Internal->Turn != 0)
  {
    this->ViewTransform->Identity();
    this->ViewTransform->RotateY(-vtkMath::DegreesFromRadians(this->Internal->Turn));
    this->ViewTransform->Concatenate(this->Transform->GetMatrix());
  }
}

void vtkWideFoVCamera::SetWarpedStereo(double iod, double distance, double offset)
{
  wfv::StereoOptions options = this->Internal->Options.Stereo;
  options.Iod = Clamp(this, "The iod", iod, 0, wfv::MostIod);
  options.Distance = distance;
  options.Offset = Clamp(this, "The offset", offset, -1, 1);
  this->SetStereoOptions(wfv::StereoWith(wfv::StereoNumber::Iod), options);
}

void vtkWideFoVCamera::SetWarpedViewer(double x, double y)
{
  wfv::StereoOptions options = this->Internal->Options.Stereo;
  options.Viewer = { { x, y } };
  this->SetStereoOptions(wfv::StereoWith(wfv::StereoNumber::Viewer), options);
}

void vtkWideFoVCamera::GetWarpedStereo(double values[3])
{
  const wfv::StereoOptions& o = this->Internal->Options.Stereo;
  values[0] = o.Iod;
  values[1] = o.Distance;
  values[2] = o.Offset;
}

void vtkWideFoVCamera::SetSeparation(double fraction)
{
  wfv::StereoOptions options = this->Internal->Options.Stereo;
  options.Separation = Clamp(this, "The separation", fraction, 0, wfv::MostSeparation);
  this->SetStereoOptions(wfv::StereoWith(wfv::StereoNumber::Separation), options);
}

double vtkWideFoVCamera::GetSeparation()
{
  return this->Internal->Options.Stereo.Separation;
}

void vtkWideFoVCamera::SetConvergence(double distance)
{
  wfv::StereoOptions options = this->Internal->Options.Stereo;
  options.Convergence = distance;
  this->SetStereoOptions(wfv::StereoWith(wfv::StereoNumber::Convergence), options);
}

double vtkWideFoVCamera::GetConvergence()
{
  return this->Internal->Options.Stereo.Convergence;
}

double vtkWideFoVCamera::GetParallax(double distance)
{
  const wfv::StereoOptions& o = this->Internal->Options.Stereo;
  return distance > 0 ? wfv::Parallax(o.Separation, o.Convergence, distance) : 0;
}

void vtkWideFoVCamera::GetDepthBudget(double range[2])
{
  const std::array<double, 2> budget = wfv::DepthBudget(this->GetConvergence());
  std::copy_n(budget.begin(), 2, range);
}

double vtkWideFoVCamera::GetParallaxAngle(double percent, double screenWidth, double viewerDistance)
{
  return screenWidth > 0 && viewerDistance > 0 && std::isfinite(percent)
    ? wfv::ParallaxAngle(percent, screenWidth, viewerDistance)
    : 0;
}

double vtkWideFoVCamera::GetLargestSeparation(double screenWidth, double eyeDistance)
{
  return screenWidth > 0 && eyeDistance > 0 ? wfv::LargestSeparation(screenWidth, eyeDistance) : 0;
}

bool vtkWideFoVCamera::ConvergeOnDepth(vtkRenderer* renderer)
{
  const wfv::StereoModel* const model = this->GetFittingModel();
  if (!renderer || !renderer->GetRenderWindow() || !model)
  {
    return false;
  }
  const bool depth = model->Has(wfv::StereoNumber::Offset);
  if (!depth && !model->Has(wfv::StereoNumber::Convergence))
  {
    return false;
  }
  std::vector<double> seen = SeenDepths(renderer);
  if (seen.empty())
  {
    return false;
  }
  if (depth)
  {
    const wfv::StereoOptions& o = this->Internal->Options.Stereo;
    this->SetWarpedStereo(o.Iod, o.Distance, wfv::Quantile(seen, 0.5));
    return true;
  }
  // of a perspective: depth to distance, by its matrix
  vtkMatrix4x4* const m = this->GetProjectionTransformMatrix(wfv::PictureAspect(renderer), -1, 1);
  for (double& depth : seen)
  {
    depth = m->GetElement(2, 3) / (m->GetElement(2, 2) + depth);
  }
  this->SetConvergence(wfv::ConvergenceFor(std::move(seen)));
  return true;
}

int vtkWideFoVCamera::GetCurrentEye()
{
  return this->Stereo ? (this->LeftEye ? LEFT_EYE : RIGHT_EYE) : MIDDLE_EYE;
}

void vtkWideFoVCamera::FindEye(vtkRenderer* renderer)
{
  vtkRenderWindow* const window = renderer->GetRenderWindow();
  const int stereo = window ? window->GetStereoRender() : 0;
  if (stereo != this->Stereo)
  {
    this->Stereo = stereo;
    this->Modified();
  }
}

const wfv::StereoModel* vtkWideFoVCamera::GetFittingModel()
{
  const wfv::StereoOptions& options = this->Internal->Options.Stereo;
  const bool fits = options.Model && options.Model->Check(options, *this->Definition).empty();
  return fits && options.Model->Traits.TwoEyes ? options.Model : nullptr;
}

void vtkWideFoVCamera::GetFlatEye(double tx, double& position, double& shift)
{
  const wfv::StereoOptions& options = this->Internal->Options.Stereo;
  const auto eye = static_cast<wfv::Eye>(this->GetCurrentEye());
  shift = this->GetFittingModel() ? wfv::SideOf(eye) * options.Separation : 0;
  position = shift * options.Convergence * tx;
}

void vtkWideFoVCamera::GetPerspectiveEye(double aspect, float eye[3])
{
  const wfv::vec3 at =
    this->IsWide() ? wfv::vec3(0) : this->GetView(aspect).Ray(wfv::vec2(0)).Origin;
  for (int i = 0; i < 3; i++)
  {
    eye[i] = static_cast<float>(at[i]);
  }
}

double vtkWideFoVCamera::GetBaselineRadius()
{
  const wfv::StereoModel* const model = this->GetFittingModel();
  const wfv::StereoOptions& o = this->Internal->Options.Stereo;
  if (model && !model->Traits.OneCenter)
  {
    return 0.5 * o.InterpupillaryDistance;
  }
  const double half = vtkMath::RadiansFromDegrees(0.5 * this->Internal->Options.HorizontalFov);
  return model && !this->IsWide() ? o.Separation * o.Convergence * std::tan(half) : 0;
}

double vtkWideFoVCamera::GetEyeReach()
{
  if (wfv::IsNews("GetEyeReach"))
  {
    vtkWarningMacro(
      "GetEyeReach is called GetBaselineRadius; the old name goes with the next release");
  }
  return this->GetBaselineRadius();
}

void vtkWideFoVCamera::GetFrustumPlanesOfBoth(double aspect, double planes[24])
{
  this->Internal->ForBothEyes = this->GetFittingModel() != nullptr;
  this->Superclass::GetFrustumPlanes(aspect, planes);
  this->Internal->ForBothEyes = false;
}
