// SPDX-License-Identifier: BSD-3-Clause
// vtkWideFoVCamera: lenses, and pictures that were measured.
#include "vtkWideFoVCamera.h"

#include "Camera/CameraInternals.h"

#include "vtkMath.h"

#include <algorithm>

bool vtkWideFoVCamera::SetLens(double c1, double c2, double c3, double c4, double c5)
{
  const double all[9] = { c1, c2, c3, c4, c5, 0, 0, 0, 0 };
  return this->SetLensCoefficients(all);
}

bool vtkWideFoVCamera::SetLensCoefficients(const double coefficients[9])
{
  wfv::LensCoefficients lens;
  std::copy_n(coefficients, lens.size(), lens.begin());
  const double rim = vtkMath::RadiansFromDegrees(0.5 * this->Internal->Options.HorizontalFov);
  // a lens may be set before its projection is
  const wfv::Projection& map =
    this->Definition->HasLens ? *this->Definition : *wfv::FindProjection("azimuthal-equidistant");
  if (!wfv::LensFits(map, lens, rim))
  {
    vtkErrorMacro(<< "The lens " << lens[0] << ", " << lens[1] << ", " << lens[2] << ", " << lens[3]
                  << ", " << lens[4] << ", " << lens[5] << ", " << lens[6] << ", " << lens[7]
                  << ", " << lens[8]
                  << " does not grow everywhere up to half the field of view; it is refused");
    return false;
  }
  this->Internal->Options.Lens = lens;
  this->Modified();
  return true;
}

void vtkWideFoVCamera::ClearLens()
{
  this->Internal->Options.Lens.fill(0);
  this->Modified();
}

void vtkWideFoVCamera::GetLens(double coefficients[5])
{
  std::copy_n(this->Internal->Options.Lens.begin(), 5, coefficients);
}

void vtkWideFoVCamera::GetLensCoefficients(double coefficients[9])
{
  std::copy_n(this->Internal->Options.Lens.begin(), 9, coefficients);
}

bool vtkWideFoVCamera::SetMeasuredPicture(
  const double size[2], const double at[2], const double focal[2])
{
  wfv::ViewOptions options;
  options.Measured.Size = wfv::vec2(size[0], size[1]);
  options.Measured.Axis = wfv::vec2(at[0], at[1]);
  options.Measured.Focal = wfv::vec2(focal[0], focal[1]);
  const std::string problem =
    wfv::CheckOptions(*wfv::FindProjection("azimuthal-equidistant"), options);
  if (!problem.empty() || !options.Measured.IsSet())
  {
    vtkErrorMacro(<< "The measured picture is refused: "
                  << (problem.empty() ? "it has no size" : problem));
    return false;
  }
  this->Internal->Options.Measured = options.Measured;
  this->Modified();
  return true;
}

void vtkWideFoVCamera::ClearMeasuredPicture()
{
  this->Internal->Options.Measured = wfv::MeasuredPicture();
  this->Modified();
}

void vtkWideFoVCamera::GetMeasuredPicture(double size[2], double at[2], double focal[2])
{
  const wfv::MeasuredPicture& m = this->Internal->Options.Measured;
  for (int i = 0; i < 2; i++)
  {
    size[i] = m.Size[i];
    at[i] = m.Axis[i];
    focal[i] = m.Focal[i];
  }
}
