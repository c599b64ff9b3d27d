// SPDX-License-Identifier: BSD-3-Clause
#include "PreviewWindow.h"

#include "Pictures/Frame.h"
#include "System/Display.h"
#include "Text/Angles.h"
#include "Viewing/Dome.h"

#include <vtkBoundingBox.h>
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
constexpr std::array<int, 2> PreviewSize{ { 640, 512 } }; // pixels
constexpr double Seat = 0.5;                              // behind the middle, radii
constexpr double Away = 3;          // of the room's middle, half its diagonals
constexpr double Aside = 25;        // degrees: where the room is seen from at first
constexpr double Nod = 0.4;         // of the tilt, that the head looks up at first
constexpr double MostPitch = 89;    // degrees
constexpr double WallRadius = 1.02; // of what is behind the picture
constexpr int Samples = 4;

// Up and down, degrees.
double FovOf(Sight sight)
{
  return sight == Sight::Seat ? 80 : sight == Sight::Middle ? 60 : 40;
}

std::string TitleOf(Sight sight)
{
  return std::string("widefov-viewer: ") +
    (sight == Sight::Seat        ? "the dome from a seat"
        : sight == Sight::Middle ? "a plain perspective"
                                 : "the room from outside");
}
}

PreviewWindow::PreviewWindow(const GlfwWindow& other, int right, Sight sight, std::size_t pictures)
  : Window(TitleOf(sight), PreviewSize, false, 0)
  , From(sight)
{
  this->Window.PlaceBeside(other, right, 0);
  this->Target->SetWindow(this->Window.GetHandle(), false);
  this->Target->SetMultiSamples(UsableSamples(Samples, QueryLimits(this->Target)));
  this->Target->AddRenderer(this->Renderer);
  for (std::size_t i = 0; i < pictures; i++)
  {
    auto surface = std::make_unique<Surface>();
    vtkNew<vtkTexture> texture;
    texture->SetInputData(surface->Image);
    texture->InterpolateOn();
    vtkNew<vtkActor> actor;
    actor->SetMapper(surface->Mapper);
    actor->SetTexture(texture);
    actor->GetProperty()->LightingOff();
    this->Renderer->AddActor(actor);
    this->Surfaces.push_back(std::move(surface));
  }
  if (sight == Sight::Room)
  {
    this->Yaw = Aside;
    this->Pitch = Aside;
    this->Turned = true;
    this->Renderer->SetBackground(0.2, 0.2, 0.25);
  }
  else
  {
    this->AddWall();
  }
}

// What is behind the picture on a dome.
void PreviewWindow::AddWall()
{
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
}

PreviewWindow::~PreviewWindow()
{
  this->Target->MakeCurrent();
  this->Target->Finalize();
}

void PreviewWindow::Set(std::size_t i, const Options& o, const Picture& picture)
{
  Surface& surface = *this->Surfaces[i];
  surface.Image->SetDimensions(picture.Width, picture.Height, 1);
  surface.Image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  const std::size_t row = 3 * static_cast<std::size_t>(picture.Width);
  auto* to = static_cast<unsigned char*>(surface.Image->GetScalarPointer());
  for (int j = picture.Height - 1; j >= 0; j--, to += row)
  {
    std::copy_n(picture.Rgb.begin() + static_cast<std::ptrdiff_t>(row * j), row, to);
  }
  surface.Image->Modified();
  const wfv::ViewOptions& v = o.View;
  const wfv::MeasuredPicture& m = v.Measured;
  const Shape shape{ o.Projection, v.HorizontalFov, v.VerticalFov, v.Tilt, v.Lens, v.Aspect,
    { { m.Size.x, m.Size.y, m.Axis.x, m.Axis.y, m.Focal.x, m.Focal.y } }, v.Map.get() };
  if (surface.Of != shape)
  {
    surface.Mapper->SetInputData(o.Screen ? MakeScreen(o.Screen->Corners) : MakeDome(o));
    surface.Of = shape;
  }
  const double nod = this->From == Sight::Seat ? Nod : 0;
  this->Pitch = this->Turned ? this->Pitch : nod * o.View.Tilt;
  this->IsNew = true;
}

void PreviewWindow::Refresh()
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
  this->PlaceCamera();
  this->Target->Render();
  CheckMessages();
  this->Window.Show();
}

void PreviewWindow::PlaceCamera()
{
  const double yaw = this->Yaw * Degree;
  const double pitch = this->Pitch * Degree;
  const double x = std::cos(pitch) * std::sin(yaw);
  const double z = std::cos(pitch) * std::cos(yaw);
  vtkCamera* const camera = this->Renderer->GetActiveCamera();
  if (this->From == Sight::Room)
  {
    vtkBoundingBox room;
    for (const std::unique_ptr<Surface>& surface : this->Surfaces)
    {
      room.AddBounds(surface->Mapper->GetBounds());
    }
    double middle[3];
    room.GetCenter(middle);
    const double away = 0.5 * Away * room.GetDiagonalLength();
    camera->SetFocalPoint(middle);
    camera->SetPosition(
      middle[0] - away * x, middle[1] + away * std::sin(pitch), middle[2] + away * z);
  }
  else
  {
    const double back = this->From == Sight::Seat ? Seat : 0;
    camera->SetPosition(0, 0, back);
    camera->SetFocalPoint(x, std::sin(pitch), back - z);
  }
  camera->SetViewUp(0, 1, 0);
  camera->SetViewAngle(FovOf(this->From));
  this->Renderer->ResetCameraClippingRange();
}

std::vector<WindowEvent> PreviewWindow::TakeEvents()
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

// As far as the middle of the window turns, wherever it was grabbed; a room follows the pointer.
void PreviewWindow::Turn(const WindowEvent& event)
{
  if (this->Dragging)
  {
    const double degrees = FovOf(this->From) / std::max(1, this->Window.GetSize()[1]);
    this->Yaw -= degrees * (event.X - this->At[0]);
    this->Pitch =
      std::clamp(this->Pitch + degrees * (event.Y - this->At[1]), -MostPitch, MostPitch);
    this->Turned = true;
    this->IsNew = true;
  }
  this->At = { { event.X, event.Y } };
}
}
