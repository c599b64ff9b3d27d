// SPDX-License-Identifier: BSD-3-Clause
#include "PickScene.h"

#include "Stereo/Stereo.h"

#include <vtkCubeSource.h>
#include <vtkMath.h>
#include <vtkMatrix4x4.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkSphereSource.h>
#include <vtkWideFoVPass.h>

#include <algorithm>
#include <cmath>

namespace wfv
{
namespace test
{
namespace
{
constexpr int Balls = 24;

// Scene units: as far apart as makes a parallax of several pixels.
constexpr double EyeDistance = 0.3;

vtkSmartPointer<vtkPolyData> Room()
{
  vtkNew<vtkCubeSource> cube;
  cube->SetXLength(14);
  cube->SetYLength(11);
  cube->SetZLength(16);
  cube->Update();
  return cube->GetOutput();
}

// The i-th of balls that are spread evenly over all directions, at several distances.
vtkSmartPointer<vtkPolyData> Ball(int i)
{
  const double up = (2.0 * i + 1) / Balls - 1;
  const double around = i * vtkMath::Pi() * (3 - std::sqrt(5.0));
  const double across = std::sqrt(1 - up * up);
  const double distance = 2.2 + 0.7 * (i % 4);
  vtkNew<vtkSphereSource> ball;
  ball->SetCenter(
    distance * across * std::cos(around), distance * up, distance * across * std::sin(around));
  ball->SetRadius(0.35 + 0.1 * (i % 3));
  ball->SetThetaResolution(12);
  ball->SetPhiResolution(9);
  ball->Update();
  return ball->GetOutput();
}
}

std::string Describe(const PickView& view)
{
  const char* const eyes[] = { ", left eye", "", ", right eye" };
  return view.Projection + eyes[static_cast<int>(view.Which) + 1];
}

PickScene::PickScene(const PickView& view)
{
  this->Add(Room());
  for (int i = 0; i < Balls; i++)
  {
    this->Add(Ball(i));
  }
  PlaceCamera(this->Window, this->Renderer, this->Camera, view);
  this->Window->SetOffScreenRendering(1);
  this->Window->SetMultiSamples(0);
  this->Window->SetSize(Width, Height);
  this->Window->AddRenderer(this->Renderer);
  this->Window->Render();
  this->MakeCaster();
}

void PickScene::Add(vtkPolyData* mesh)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(mesh);
  this->Bodies.push_back(vtkSmartPointer<vtkActor>::New());
  this->Bodies.back()->SetMapper(mapper);
  this->Renderer->AddActor(this->Bodies.back());
}

void PlaceCamera(vtkRenderWindow* window, vtkWideFoVRenderer* renderer, vtkWideFoVCamera* camera,
  const PickView& view)
{
  camera->SetProjection(view.Projection.c_str());
  camera->SetPosition(0.1, 0.05, 0.07);
  camera->SetFocalPoint(0.6, 0.25, -2.3);
  camera->SetTilt(view.Tilt);
  if (view.Which != Eye::Middle)
  {
    camera->SetStereoModel("omnidirectional");
    camera->SetInterpupillaryDistance(EyeDistance);
    window->SetStereoType(view.Which == Eye::Left ? VTK_STEREO_LEFT : VTK_STEREO_RIGHT);
    window->StereoRenderOn();
  }
  renderer->SetActiveCamera(camera);
  vtkWideFoVPass::SafeDownCast(renderer->GetPass())->SetTechniqueToExact();
}

void PickScene::MakeCaster()
{
  reference::Pose pose;
  std::copy_n(this->Camera->GetModelViewTransformMatrix()->GetData(), 16, pose.begin());
  reference::TriangleSoup soup;
  vtkIdType first = 0;
  for (const auto& body : this->Bodies)
  {
    auto* const mesh = vtkPolyData::SafeDownCast(body->GetMapper()->GetInput());
    reference::Append(soup, mesh, pose, first);
    this->FirstCells.push_back(first);
    first += mesh->GetNumberOfCells();
  }
  const View& view = this->Camera->GetView(double(Width) / Height);
  this->Caster = std::make_unique<reference::RayCaster>(std::move(soup), view);
}

PickedCell PickScene::See(double x, double y) const
{
  const vec2 ndc(2 * x / Width - 1, 2 * y / Height - 1);
  const reference::Hit hit = this->Caster->Cast(ndc);
  if (hit.Cell < 0)
  {
    return {};
  }
  const auto next =
    std::upper_bound(this->FirstCells.begin(), this->FirstCells.end(), hit.Cell) - 1;
  return { this->Bodies[next - this->FirstCells.begin()], hit.Cell - *next };
}

bool PickScene::SeesNear(double x, double y, double radius, const PickedCell& cell) const
{
  constexpr int Directions = 16;
  bool seen = this->See(x, y) == cell;
  for (int i = 0; i < Directions && !seen; i++)
  {
    const double a = 2 * vtkMath::Pi() * i / Directions;
    seen = this->See(x + radius * std::cos(a), y + radius * std::sin(a)) == cell;
  }
  return seen;
}
}
}
