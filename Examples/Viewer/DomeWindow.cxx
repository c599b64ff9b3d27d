// SPDX-License-Identifier: BSD-3-Clause
#include "DomeWindow.h"

#include "Angles.h"
#include "Display.h"
#include "Dome.h"
#include "Frame.h"

#include <vtkCamera.h>
#include <vtkProperty.h>
#include <vtkSphereSource.h>
#include <vtkTexture.h>

#include <algorithm>
#include <cmath>

namespace widefov
{
namespace
{
constexpr std::array<int, 2> DomeSize{ { 640, 512 } }; // pixels
constexpr double Seat = 0.5;                           // behind the middle, radii
constexpr double SeatFov = 80;                         // degrees, up and down
constexpr double Nod = 0.4;         // of the tilt, that the head looks up at first
constexpr double MostPitch = 89;    // degrees
constexpr double WallRadius = 1.02; // of what is behind the picture
constexpr int Samples = 4;
}

DomeWindow::DomeWindow(const GlfwWindow& other)
  : Window("widefov-viewer: the dome from a seat", DomeSize, false, 0)
{
  this->Window.PlaceBeside(other, other.GetSize()[0], 0);
  this->Target->SetWindow(this->Window.GetHandle(), false);
  this->Target->SetMultiSamples(UsableSamples(Samples, QueryLimits(this->Target)));
  this->Target->AddRenderer(this->Renderer);
  vtkNew<vtkTexture> texture;
  texture->SetInputData(this->Image);
  texture->InterpolateOn();
  vtkNew<vtkActor> dome;
  dome->SetMapper(this->Mapper);
  dome->SetTexture(texture);
  dome->GetProperty()->LightingOff();
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(WallRadius);
  sphere->SetThetaResolution(36);
  sphere->SetPhiResolution(19);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(sphere->GetOutputPort());
  vtkNew<vtkActor> wall;
  wall->SetMapper(mapper);
  wall->GetProperty()->LightingOff();
  wall->GetProperty()->SetColor(0.2, 0.2, 0.25);
  wall->GetProperty()->SetRepresentationToWireframe();
  this->Renderer->AddActor(wall);
  this->Renderer->AddActor(dome);
}

DomeWindow::~DomeWindow()
{
  this->Target->MakeCurrent();
  this->Target->Finalize();
}

void DomeWindow::Set(const Options& o, const Picture& picture)
{
  this->Image->SetDimensions(picture.Width, picture.Height, 1);
  this->Image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  const std::size_t row = 3 * static_cast<std::size_t>(picture.Width);
  auto* to = static_cast<unsigned char*>(this->Image->GetScalarPointer());
  for (int j = picture.Height - 1; j >= 0; j--, to += row)
  {
    std::copy_n(picture.Rgb.begin() + static_cast<std::ptrdiff_t>(row * j), row, to);
  }
  this->Image->Modified();
  const wfv::ViewOptions& v = o.View;
  const wfv::MeasuredPicture& m = v.Measured;
  const Shape shape{ o.Projection, v.HorizontalFov, v.VerticalFov, v.Tilt, v.Lens, v.Aspect,
    { { m.Size.x, m.Size.y, m.Axis.x, m.Axis.y, m.Focal.x, m.Focal.y } }, v.Map.get() };
  if (this->Of != shape)
  {
    this->Mapper->SetInputData(MakeDome(o));
    this->Of = shape;
  }
  this->Pitch = this->Turned ? this->Pitch : Nod * o.View.Tilt;
  this->IsNew = true;
}

void DomeWindow::Refresh()
{
  this->Window.CheckAlive();
  const std::array<int, 2> size = this->Window.GetSize();
  this->IsNew = this->Window.TakeDamage() || this->IsNew;
  if (!this->IsNew || size[0] <= 0 || size[1] <= 0)
  {
    return;
  }
  this->IsNew = false;
  this->Target->MakeCurrent();
  this->Target->SetSize(size[0], size[1]);
  const double yaw = this->Yaw * Degree;
  const double pitch = this->Pitch * Degree;
  vtkCamera* const camera = this->Renderer->GetActiveCamera();
  camera->SetPosition(0, 0, Seat);
  camera->SetFocalPoint(
    std::cos(pitch) * std::sin(yaw), std::sin(pitch), Seat - std::cos(pitch) * std::cos(yaw));
  camera->SetViewUp(0, 1, 0);
  camera->SetViewAngle(SeatFov);
  this->Renderer->ResetCameraClippingRange();
  this->Target->Render();
  CheckMessages();
  this->Window.Show();
}

std::vector<WindowEvent> DomeWindow::TakeEvents()
{
  std::vector<WindowEvent> keys;
  for (const WindowEvent& event : this->Window.TakeEvents())
  {
    switch (event.What)
    {
      case WindowEvent::Kind::ButtonPress:
      case WindowEvent::Kind::ButtonRelease:
        this->Dragging = event.What == WindowEvent::Kind::ButtonPress;
        break;
      case WindowEvent::Kind::Cursor:
        this->Turn(event);
        break;
      case WindowEvent::Kind::Wheel:
        break;
      default:
        keys.push_back(event);
        break;
    }
  }
  return keys;
}

// As far as the middle of the window turns, wherever it was grabbed.
void DomeWindow::Turn(const WindowEvent& event)
{
  if (this->Dragging)
  {
    const double degrees = SeatFov / std::max(1, this->Window.GetSize()[1]);
    this->Yaw -= degrees * (event.X - this->At[0]);
    this->Pitch =
      std::clamp(this->Pitch + degrees * (event.Y - this->At[1]), -MostPitch, MostPitch);
    this->Turned = true;
    this->IsNew = true;
  }
  this->At = { { event.X, event.Y } };
}
}
