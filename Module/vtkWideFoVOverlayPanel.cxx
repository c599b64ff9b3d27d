// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWideFoVOverlayPanel.h"

#include "OverlayPicture.h"
#include "vtkWideFoVPolyDataMapper.h"

#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkCommand.h"
#include "vtkFloatArray.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkTexture.h"

#include <cmath>

vtkStandardNewMacro(vtkWideFoVOverlayPanel);

vtkWideFoVOverlayPanel::vtkWideFoVOverlayPanel()
{
  this->ForceTranslucentOn();
  this->GetProperty()->LightingOff();
  this->SetUserMatrix(this->Axes);
}

vtkWideFoVOverlayPanel::~vtkWideFoVOverlayPanel()
{
  this->Follow(nullptr);
}

void vtkWideFoVOverlayPanel::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Azimuth: " << this->Azimuth << "\n"
     << indent << "Elevation: " << this->Elevation << "\n"
     << indent << "Angle: " << this->Angle << "\n"
     << indent << "Depth: " << this->Depth << "\n"
     << indent << "Followed: " << this->Followed.Get() << "\n";
}

void vtkWideFoVOverlayPanel::SetDirection(double azimuth, double elevation)
{
  if (!std::isfinite(azimuth) || !(std::abs(elevation) <= 90))
  {
    vtkErrorMacro("there is no direction " << azimuth << ", " << elevation);
    return;
  }
  this->Azimuth = azimuth;
  this->Elevation = elevation;
  this->Place();
}

void vtkWideFoVOverlayPanel::SetAngle(double degrees)
{
  if (!(degrees > 0 && degrees < 180))
  {
    vtkErrorMacro("the angle is more than 0 and less than 180, not " << degrees);
    return;
  }
  this->Angle = degrees;
  this->Place();
}

void vtkWideFoVOverlayPanel::SetDepth(double depth)
{
  if (!(depth > 0 && std::isfinite(depth)))
  {
    vtkErrorMacro("the depth is a length, not " << depth);
    return;
  }
  this->Depth = depth;
  this->Place();
}

bool vtkWideFoVOverlayPanel::SetOverlay(vtkProp* overlay, int width, int height)
{
  if (!overlay || width < 1 || height < 1)
  {
    vtkErrorMacro("a panel needs an overlay, and pixels, not " << width << " x " << height);
    return false;
  }
  vtkNew<vtkTexture> texture;
  texture->SetInputData(wfv::MakeOverlayPicture(overlay, width, height));
  texture->InterpolateOn();
  texture->MipmapOn();
  this->SetTexture(texture);
  this->Pixels[0] = width;
  this->Pixels[1] = height;
  this->Place();
  return true;
}

// A rectangle that faces the eye, in the camera's axes: x right, y up, looking down -z.
void vtkWideFoVOverlayPanel::Place()
{
  const double a = vtkMath::RadiansFromDegrees(this->Azimuth);
  const double e = vtkMath::RadiansFromDegrees(this->Elevation);
  const double middle[] = { std::sin(a) * std::cos(e), std::sin(e), -std::cos(a) * std::cos(e) };
  const double right[] = { std::cos(a), 0, std::sin(a) };
  const double up[] = { -std::sin(a) * std::sin(e), std::cos(e), std::cos(a) * std::sin(e) };
  const double half = std::tan(vtkMath::RadiansFromDegrees(this->Angle) / 2);
  const double high = half * this->Pixels[1] / this->Pixels[0];
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> places;
  places->SetNumberOfComponents(2);
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell(4);
  for (int i = 0; i < 4; i++)
  {
    const double x = i == 1 || i == 2 ? 1 : 0;
    const double y = i / 2;
    double corner[3];
    for (int k = 0; k < 3; k++)
    {
      corner[k] =
        this->Depth * (middle[k] + (2 * x - 1) * half * right[k] + (2 * y - 1) * high * up[k]);
    }
    cells->InsertCellPoint(points->InsertNextPoint(corner));
    places->InsertNextTuple2(x, y);
  }
  vtkNew<vtkPolyData> panel;
  panel->SetPoints(points);
  panel->SetPolys(cells);
  panel->GetPointData()->SetTCoords(places);
  vtkNew<vtkWideFoVPolyDataMapper> mapper;
  mapper->SetInputData(panel);
  this->SetMapper(mapper);
}

void vtkWideFoVOverlayPanel::Follow(vtkRenderer* renderer)
{
  if (this->Followed)
  {
    this->Followed->RemoveObserver(this->Observer);
  }
  this->Followed = renderer;
  if (renderer)
  {
    this->Observer =
      renderer->AddObserver(vtkCommand::StartEvent, this, &vtkWideFoVOverlayPanel::Turn);
  }
}

void vtkWideFoVOverlayPanel::Turn()
{
  vtkMatrix4x4::Invert(this->Followed->GetActiveCamera()->GetViewTransformMatrix(), this->Axes);
}
