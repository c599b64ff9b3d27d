// SPDX-License-Identifier: BSD-3-Clause
#include "Grabs.h"

#include <vtkBoxRepresentation.h>
#include <vtkBoxWidget2.h>
#include <vtkHandleWidget.h>
#include <vtkLineRepresentation.h>
#include <vtkLineWidget2.h>
#include <vtkMath.h>
#include <vtkPolyData.h>
#include <vtkPointHandleRepresentation3D.h>
#include <vtkSphereRepresentation.h>
#include <vtkSphereWidget2.h>

#include <algorithm>
#include <cmath>

namespace wfv
{
namespace test
{
namespace
{
// Pixels: the mouse has whole ones, VTK adds up the steps of a drag as vectors, and what is grabbed
// of a handle's cross may be a little nearer than its middle.
constexpr double UnderPointer = 3;

// Pixels, half of the way of a drag: a ball is drawn of flat pieces, and is grabbed at one of them.
constexpr double UnderPointerOfBall = 6;

// Scene units: what is as good as where it was.
constexpr double Same = 1e-6;

// Steps of a drag: some widgets wait for the fourth.
constexpr int Steps = 5;

double Apart(const Place& a, const Place& b)
{
  return std::sqrt(vtkMath::Distance2BetweenPoints(a.data(), b.data()));
}

Place Moved(const Place& p, int axis, double by)
{
  Place moved = p;
  moved[axis] += by;
  return moved;
}

// Switches a widget on, placed in a cube round a place.
template <typename Widget, typename Representation>
void Show(GrabStage& stage, Widget* widget, Representation* shown, const Place& at)
{
  double bounds[6];
  for (int i = 0; i < 6; i++)
  {
    bounds[i] = at[i / 2] + (i % 2 ? 0.5 : -0.5);
  }
  shown->SetPlaceFactor(1);
  widget->SetInteractor(stage.Interactor);
  widget->SetDefaultRenderer(stage.Renderer);
  widget->SetRepresentation(shown);
  shown->SetRenderer(stage.Renderer);
  shown->PlaceWidget(bounds);
  widget->On();
}

std::string At(const char* what, const Place& p)
{
  return std::string(what) + " (" + std::to_string(p[0]) + ", " + std::to_string(p[1]) + ", " +
    std::to_string(p[2]) + ")";
}
}

GrabStage::GrabStage(const PickView& view, unsigned int seed)
  : Engine(seed)
{
  this->Window->SetOffScreenRendering(1);
  this->Window->SetMultiSamples(0);
  this->Window->SetSize(PickScene::Width, PickScene::Height);
  this->Window->AddRenderer(this->Renderer);
  this->Interactor->SetRenderWindow(this->Window);
  this->Interactor->SetInteractorStyle(nullptr);
  this->Interactor->EnableRenderOff(); // a picture before each drag is enough
  PlaceCamera(this->Window, this->Renderer, this->Camera, view);
  this->Interactor->Initialize();
  this->Window->Render(); // by which the camera knows the eye
}

Pixel GrabStage::SeenAt(const Place& place)
{
  this->Renderer->SetWorldPoint(place[0], place[1], place[2], 1);
  this->Renderer->WorldToDisplay();
  const double* const d = this->Renderer->GetDisplayPoint();
  return { int(std::lround(d[0])), int(std::lround(d[1])) };
}

double GrabStage::DistanceFrom(const Place& place, const Pixel& pixel)
{
  const Pixel seen = this->SeenAt(place);
  return std::hypot(seen[0] - pixel[0], seen[1] - pixel[1]);
}

bool GrabStage::IsNearSeam(const Place& place)
{
  const Pixel middle = this->SeenAt(place);
  for (int i = 0; i < 6; i++)
  {
    const Pixel p = this->SeenAt(Moved(place, i / 2, i % 2 ? 1 : -1));
    const bool outside =
      p[0] < 15 || p[0] > PickScene::Width - 15 || p[1] < 15 || p[1] > PickScene::Height - 15;
    if (outside || std::hypot(p[0] - middle[0], p[1] - middle[1]) > 0.2 * PickScene::Width)
    {
      return true;
    }
  }
  return false;
}

Place GrabStage::AnyPlace()
{
  std::normal_distribution<double> any;
  std::uniform_real_distribution<double> distance(3, 5);
  Place place;
  do
  {
    for (double& x : place)
    {
      x = any(this->Engine);
    }
    vtkMath::Normalize(place.data());
    vtkMath::MultiplyScalar(place.data(), distance(this->Engine));
  } while (this->IsNearSeam(place));
  return place;
}

Pixel GrabStage::Beside(const Pixel& from)
{
  std::uniform_real_distribution<double> angle(0, 2 * vtkMath::Pi());
  const double a = angle(this->Engine);
  return { from[0] + int(12 * std::cos(a)), from[1] + int(12 * std::sin(a)) };
}

void GrabStage::Drag(const Pixel& from, const Pixel& to)
{
  const auto send = [this](double x, double y, unsigned long event) {
    this->Interactor->SetEventInformation(int(std::lround(x)), int(std::lround(y)));
    this->Interactor->InvokeEvent(event);
  };
  this->Window->Render();
  send(from[0], from[1], vtkCommand::MouseMoveEvent);
  send(from[0], from[1], vtkCommand::LeftButtonPressEvent);
  for (int i = 1; i <= Steps; i++)
  {
    const double t = double(i) / Steps;
    send(
      from[0] + t * (to[0] - from[0]), from[1] + t * (to[1] - from[1]), vtkCommand::MouseMoveEvent);
  }
  send(to[0], to[1], vtkCommand::LeftButtonReleaseEvent);
}

std::string GrabHandle(GrabStage& stage)
{
  // the other one is behind the eye as seen from this one
  Place at = stage.AnyPlace();
  Place other = { -at[0], -at[1], -at[2] };
  vtkNew<vtkHandleWidget> widget;
  vtkNew<vtkPointHandleRepresentation3D> shown;
  vtkNew<vtkHandleWidget> behind;
  vtkNew<vtkPointHandleRepresentation3D> shownBehind;
  Show(stage, behind.Get(), shownBehind.Get(), other);
  Show(stage, widget.Get(), shown.Get(), at);
  shown->SetWorldPosition(at.data());
  shownBehind->SetWorldPosition(other.data());
  const Pixel from = stage.SeenAt(at);
  const Pixel to = stage.Beside(from);
  stage.Drag(from, to);
  Place now;
  Place otherNow;
  shown->GetWorldPosition(now.data());
  shownBehind->GetWorldPosition(otherNow.data());
  const bool follows = stage.DistanceFrom(now, to) <= UnderPointer;
  const double farther = vtkMath::Norm(now.data()) / vtkMath::Norm(at.data());
  const bool stays = Apart(otherNow, other) < Same && std::abs(farther - 1) < 0.1;
  return follows && stays ? "" : At("the handle at", at) + At(" goes to", now);
}

std::string GrabEndOfLine(GrabStage& stage)
{
  Place at = stage.AnyPlace();
  Place other = stage.AnyPlace();
  vtkNew<vtkLineWidget2> widget;
  vtkNew<vtkLineRepresentation> shown;
  Show(stage, widget.Get(), shown.Get(), at);
  shown->SetPoint1WorldPosition(at.data());
  shown->SetPoint2WorldPosition(other.data());
  const Pixel from = stage.SeenAt(at);
  if (stage.DistanceFrom(other, from) < 40)
  {
    return GrabEndOfLine(stage);
  }
  const Pixel to = stage.Beside(from);
  stage.Drag(from, to);
  Place now;
  Place otherNow;
  shown->GetPoint1WorldPosition(now.data());
  shown->GetPoint2WorldPosition(otherNow.data());
  const bool right = stage.DistanceFrom(now, to) <= UnderPointer && Apart(otherNow, other) < Same;
  return right ? "" : At("the end of a line at", at) + At(" goes to", now);
}

namespace
{
// Where the ray of a pixel meets a ball of this radius.
Place MeetBall(GrabStage& stage, const Pixel& pixel, const Place& center, double radius)
{
  Place origin;
  Place direction;
  Place toCenter;
  stage.Renderer->DisplayToRay(pixel[0], pixel[1], origin.data(), direction.data());
  vtkMath::Subtract(center.data(), origin.data(), toCenter.data());
  const double along = vtkMath::Dot(toCenter.data(), direction.data());
  const double beside = vtkMath::Dot(toCenter.data(), toCenter.data()) - along * along;
  const double t = along - std::sqrt(std::max(0.0, radius * radius - beside));
  for (int i = 0; i < 3; i++)
  {
    origin[i] += t * direction[i];
  }
  return origin;
}
}

std::string GrabSphere(GrabStage& stage)
{
  Place at = stage.AnyPlace();
  vtkNew<vtkSphereWidget2> widget;
  vtkNew<vtkSphereRepresentation> shown;
  Show(stage, widget.Get(), shown.Get(), at);
  shown->SetRepresentationToSurface();
  shown->RadialLineOff(); // with either VTK asks for the handle first, seen or not
  shown->HandleTextOff();
  const Pixel from = stage.SeenAt(at);
  const Pixel to = stage.Beside(from);
  Place grabbed = MeetBall(stage, from, at, 0.5);
  stage.Drag(from, to);
  Place now;
  shown->GetCenter(now.data());
  for (int i = 0; i < 3; i++)
  {
    grabbed[i] += now[i] - at[i];
  }
  return stage.DistanceFrom(grabbed, to) <= UnderPointerOfBall
    ? ""
    : At("the ball at", at) + At(" goes to", now);
}

std::string GrabHandleOfSphere(GrabStage& stage)
{
  Place at = stage.AnyPlace();
  vtkNew<vtkSphereWidget2> widget;
  vtkNew<vtkSphereRepresentation> shown;
  Show(stage, widget.Get(), shown.Get(), at);
  shown->SetRepresentationToSurface();
  shown->HandleVisibilityOn();
  Place direction; // towards the eye, a little turned
  for (int i = 0; i < 3; i++)
  {
    direction[i] = -at[i] + at[(i + 1) % 3] * 0.3;
  }
  shown->SetHandleDirection(direction.data());
  shown->BuildRepresentation();
  Place handle;
  Place now;
  Place center;
  shown->GetHandlePosition(handle.data());
  const Pixel from = stage.SeenAt(handle);
  const Pixel middle = stage.SeenAt(at);
  const Pixel to = { (from[0] + middle[0]) / 2, (from[1] + middle[1]) / 2 };
  stage.Drag(from, to);
  shown->GetHandlePosition(now.data());
  shown->GetCenter(center.data());
  const bool right = stage.DistanceFrom(now, to) <= UnderPointer && Apart(center, at) < Same;
  return right ? "" : At("the handle of a ball at", handle) + At(" goes to", now);
}

namespace
{
// The middle of a face: -x, +x, -y, ..
Place FaceOf(vtkBoxRepresentation* box, int face)
{
  vtkNew<vtkPolyData> corners;
  box->GetPolyData(corners);
  Place place;
  corners->GetPoint(8 + face, place.data());
  return place;
}

// The face whose handle is seen farthest from the middle.
int OutermostFace(GrabStage& stage, const Place& at)
{
  const Pixel middle = stage.SeenAt(at);
  int best = 0;
  for (int face = 1; face < 6; face++)
  {
    const auto away = [&](int f) {
      return stage.DistanceFrom(Moved(at, f / 2, f % 2 ? 0.5 : -0.5), middle);
    };
    best = away(face) > away(best) ? face : best;
  }
  return best;
}
}

std::string GrabFaceOfBox(GrabStage& stage)
{
  const Place at = stage.AnyPlace();
  vtkNew<vtkBoxWidget2> widget;
  vtkNew<vtkBoxRepresentation> shown;
  Show(stage, widget.Get(), shown.Get(), at);
  const int face = OutermostFace(stage, at);
  const int opposite = face ^ 1;
  const double out = face % 2 ? 0.3 : -0.3;
  const Place handle = FaceOf(shown, face);
  const Place other = FaceOf(shown, opposite);
  stage.Drag(stage.SeenAt(handle), stage.SeenAt(Moved(handle, face / 2, out)));
  const Place now = FaceOf(shown, face);
  // as far as was dragged, but for what leads to the eye or away
  const bool right = std::abs((now[face / 2] - handle[face / 2]) / out - 1) < 0.6 &&
    Apart(FaceOf(shown, opposite), other) < Same;
  return right ? "" : At("the handle of a box at", handle) + At(" goes to", now);
}
}
}
