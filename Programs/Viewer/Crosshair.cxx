// SPDX-License-Identifier: BSD-3-Clause
#include "Crosshair.h"

#include "Scenes/MeshBuilder.h"

#include <vtkMatrix4x4.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkWideFoVCamera.h>

#include <algorithm>
#include <cmath>

namespace widefov
{
namespace
{
constexpr double Arm = 16;       // pixels from the middle to an end
constexpr float LineWidth = 2;   // pixels
constexpr float BorderWidth = 4; // pixels

// Of the crosshair's distance, where its border is: the same picture for the eye that points, and
// for the other one within a thousandth of the parallax.
constexpr double Behind = 1.001;

struct Ray
{
  Vector3 Origin;
  Vector3 Direction; // unit length
};

// A place of the scene's whole picture, NDC, and a pixel of it.
struct Spot
{
  std::array<double, 2> Ndc;
  std::array<double, 2> Step;
};

std::optional<Ray> RayAt(vtkWideFoVRenderer* scene, const Spot& spot, double right, double up)
{
  auto* const camera = vtkWideFoVCamera::SafeDownCast(scene->GetActiveCamera());
  if (camera == nullptr)
  {
    return std::nullopt; // stock VTK's cubemap
  }
  const double ndc[2] = { spot.Ndc[0] + right * spot.Step[0], spot.Ndc[1] + up * spot.Step[1] };
  const int* const whole = scene->GetRenderWindow()->GetSize();
  Ray ray;
  const bool inside =
    camera->NDCToRay(ndc, double(whole[0]) / whole[1], ray.Origin.data(), ray.Direction.data());
  return inside ? std::optional(ray) : std::nullopt;
}

// How far along the ray a perspective has that depth, NDC: there z is depth times w.
double DistanceInPerspective(vtkMatrix4x4* m, const Ray& ray, double depth)
{
  const auto rows = [&](const Vector3& v, double w) {
    double clip[4] = { v[0], v[1], v[2], w };
    m->MultiplyPoint(clip, clip);
    return clip[2] - depth * clip[3];
  };
  return -rows(ray.Origin, 1) / rows(ray.Direction, 0);
}

// What the scene shows there; `pixel`: of the window, from its lower left.
std::optional<Vector3> SeenAt(
  vtkWideFoVRenderer* scene, const Spot& spot, const Ray& ray, const std::array<int, 2>& pixel)
{
  float depth = 1;
  scene->GetRenderWindow()->GetZbufferData(pixel[0], pixel[1], pixel[0], pixel[1], &depth);
  if (!(depth > 0) || !(depth < 1))
  {
    return std::nullopt;
  }
  auto* const camera = vtkWideFoVCamera::SafeDownCast(scene->GetActiveCamera());
  const int* const whole = scene->GetRenderWindow()->GetSize();
  const double aspect = double(whole[0]) / whole[1];
  const double ndc[3] = { spot.Ndc[0], spot.Ndc[1], 2. * depth - 1 };
  Vector3 at;
  if (camera->IsWide())
  {
    camera->NDCToWorld(ndc, aspect, at.data());
    return at;
  }
  vtkMatrix4x4* const m = camera->GetCompositeProjectionTransformMatrix(aspect, -1, 1);
  return ray.Origin + DistanceInPerspective(m, ray, ndc[2]) * ray.Direction;
}

// Radians from the ray to those of the pixels beside it, the farthest: where the map stretches
// one way the crosshair does as well, and is nowhere shorter than it should be.
double AngleOfPixel(vtkWideFoVRenderer* scene, const Spot& spot, const Ray& ray)
{
  double angle = 0;
  constexpr int Beside[4][2] = { { 1, 0 }, { -1, 0 }, { 0, 1 }, { 0, -1 } };
  for (const auto& step : Beside)
  {
    if (const std::optional<Ray> next = RayAt(scene, spot, step[0], step[1]))
    {
      angle = std::max(angle, Length(next->Direction - ray.Direction));
    }
  }
  return angle;
}
}

Crosshair::Crosshair()
{
  this->Lines->AllOff();
  this->Lines->AxesOn();
  this->Lines->SetModelBounds(-1, 1, -1, 1, -1, 1);
  this->Lines->SetFocalPoint(0, 0, 0);
  this->Border->GetProperty()->SetColor(0, 0, 0);
  this->Border->GetProperty()->SetLineWidth(BorderWidth);
  this->Cross->GetProperty()->SetColor(1, 1, 1);
  this->Cross->GetProperty()->SetLineWidth(LineWidth);
  for (vtkActor* const actor : { this->Border.Get(), this->Cross.Get() })
  {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(this->Lines->GetOutputPort());
    actor->SetMapper(mapper);
    actor->GetProperty()->LightingOff();
    this->Renderer->AddActor(actor);
  }
  this->Renderer->SetLayer(1);
  this->Renderer->InteractiveOff();
  this->Renderer->DrawOff();
}

void Crosshair::Find(vtkWideFoVRenderer* scene, Aim& aim)
{
  const int* const whole = scene->GetRenderWindow()->GetSize();
  const int* const own = scene->GetRenderWindow()->GetActualSize();
  const std::array<int, 2> pixel{ { std::clamp(static_cast<int>((*aim.Pointer)[0]), 0, own[0] - 1),
    std::clamp(own[1] - 1 - static_cast<int>((*aim.Pointer)[1]), 0, own[1] - 1) } };
  double tile[4];
  scene->GetRenderWindow()->GetTileViewport(tile);
  const double* const view = scene->GetViewport();
  Spot spot;
  for (std::size_t i = 0; i < 2; i++)
  {
    const double extent = view[i + 2] - view[i];
    spot.Step[i] = 2. / (whole[i] * extent);
    spot.Ndc[i] = 2 * (tile[i] - view[i]) / extent - 1 + spot.Step[i] * (pixel[i] + 0.5);
  }
  const std::optional<Ray> ray = RayAt(scene, spot, 0, 0);
  if (!ray)
  {
    return; // beside the picture
  }
  const double before = aim.At ? Length(*aim.At - ray->Origin)
                               : scene->GetActiveCamera()->GetDistance(); // the scene's size
  const Vector3 nowhere = ray->Origin + before * ray->Direction;
  aim.Eye = ray->Origin;
  aim.At = SeenAt(scene, spot, *ray, pixel).value_or(nowhere);
  aim.Pixel = Length(*aim.At - ray->Origin) * AngleOfPixel(scene, spot, *ray);
}

void Crosshair::Show(const Aim* aim)
{
  const bool shown = aim != nullptr && aim->At && aim->Pixel > 0;
  this->Renderer->SetDraw(shown);
  if (!shown)
  {
    return;
  }
  const auto place = [&](vtkActor* actor, double distance) {
    const Vector3 at = aim->Eye + distance * (*aim->At - aim->Eye);
    actor->SetPosition(at[0], at[1], at[2]);
    actor->SetScale(distance * Arm * aim->Pixel);
  };
  place(this->Cross, 1);
  place(this->Border, Behind);
}
}
