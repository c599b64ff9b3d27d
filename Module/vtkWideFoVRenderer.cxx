// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWideFoVRenderer.h"

#include "Camera/AreaQuestions.h"
#include "Camera/Tile.h"
#include "Compat/Reports.h"
#include "InsidePlace.h"
#include "PassChain.h"
#include "PickerAnswer.h"
#include "vtkWideFoVCamera.h"
#include "vtkWideFoVPass.h"

#include "vtkBoundingBox.h"
#include "vtkCommand.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLGL2PSHelper.h"

#include <algorithm>
#include <utility>

vtkStandardNewMacro(vtkWideFoVRenderer);

vtkWideFoVRenderer::vtkWideFoVRenderer()
  : Areas(std::make_unique<wfv::AreaQuestions>())
{
  this->SetPass(this->OwnPass);
}

vtkWideFoVRenderer::~vtkWideFoVRenderer()
{
  this->WarnOfArea();
}

void vtkWideFoVRenderer::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "GradientByDirection: " << this->GradientByDirection << "\n";
}

vtkWideFoVRenderer::BackgroundDrawer::BackgroundDrawer(
  vtkRenderer* renderer, std::function<void()> draw)
  : Renderer(vtkWideFoVRenderer::SafeDownCast(renderer))
{
  if (this->Renderer)
  {
    this->Renderer->DrawGradient = std::move(draw);
  }
}

vtkWideFoVRenderer::BackgroundDrawer::~BackgroundDrawer()
{
  if (this->Renderer)
  {
    this->Renderer->DrawGradient = nullptr;
  }
}

void vtkWideFoVRenderer::Clear()
{
  const bool own = this->GradientByDirection && this->GradientBackground &&
    !this->TexturedBackground && this->DrawGradient && !this->Transparent();
  if (!own)
  {
    this->Superclass::Clear();
    return;
  }
  this->GradientBackground = false;
  this->Superclass::Clear();
  this->GradientBackground = true;
  this->DrawGradient();
}

vtkCamera* vtkWideFoVRenderer::MakeCamera()
{
  vtkCamera* camera = vtkWideFoVCamera::New();
  this->InvokeEvent(vtkCommand::CreateCameraEvent, camera);
  return camera;
}

vtkWideFoVCamera* vtkWideFoVRenderer::GetWideCamera()
{
  auto* camera = vtkWideFoVCamera::SafeDownCast(this->ActiveCamera);
  return camera && camera->IsWide() ? camera : nullptr;
}

bool vtkWideFoVRenderer::HasFlatEye()
{
  auto* camera = vtkWideFoVCamera::SafeDownCast(this->ActiveCamera);
  return camera && !camera->IsWide() && camera->GetCurrentEye() != vtkWideFoVCamera::MIDDLE_EYE &&
    camera->GetBaselineRadius() > 0;
}

void vtkWideFoVRenderer::PoseToView(double& x, double& y, double& z)
{
  vtkWideFoVCamera* camera = this->GetWideCamera();
  if (!camera)
  {
    this->Superclass::PoseToView(x, y, z);
    return;
  }
  double p[4] = { x, y, z, 1 };
  vtkNew<vtkMatrix4x4> inverse;
  vtkMatrix4x4::Invert(camera->GetViewTransformMatrix(), inverse);
  inverse->MultiplyPoint(p, p);
  x = p[0];
  y = p[1];
  z = p[2];
  this->WorldToView(x, y, z);
}

void vtkWideFoVRenderer::ViewToPose(double& x, double& y, double& z)
{
  vtkWideFoVCamera* camera = this->GetWideCamera();
  if (!camera)
  {
    this->Superclass::ViewToPose(x, y, z);
    return;
  }
  this->ViewToWorld(x, y, z);
  this->WorldToPose(x, y, z);
}

void vtkWideFoVRenderer::WorldToView(double& x, double& y, double& z)
{
  vtkWideFoVCamera* camera = this->GetWideCamera();
  if (this->HasFlatEye())
  {
    // by two steps: by one VTK takes the middle between the eyes, where no picture is drawn from
    const double place[3] = { x, y, z };
    this->WorldToPose(x, y, z);
    this->PoseToView(x, y, z);
    vtkWideFoVCamera::SafeDownCast(this->ActiveCamera)->GetFlatQuestions().AskDepth(place, z);
    return;
  }
  if (!camera)
  {
    this->Superclass::WorldToView(x, y, z);
    return;
  }
  const double world[3] = { x, y, z };
  double ndc[3];
  camera->WorldToNDC(world, wfv::PictureAspect(this), ndc);
  x = ndc[0];
  y = ndc[1];
  z = 0.5 * (ndc[2] + 1); // VTK's view depth is 0 to 1
  camera->GetFlatQuestions().AskDepth(world, z);
}

bool vtkWideFoVRenderer::AnswerPicker(double& x, double& y, double& z)
{
  using Asker = wfv::FlatQuestions::Asker;
  auto* camera = vtkWideFoVCamera::SafeDownCast(this->ActiveCamera);
  const double ndc[2] = { x, y };
  const Asker asker = camera ? camera->GetFlatQuestions().AskPlace(ndc, z) : Asker::Any;
  if (asker == Asker::Any)
  {
    return false;
  }
  double place[3];
  if (asker == Asker::Picker)
  {
    camera->GetFlatQuestions().Answer(wfv::FindPickRay(this, camera, ndc), place);
  }
  else
  {
    const double* const middle = camera->GetFlatQuestions().GetMiddle().data();
    const double diagonal = wfv::FindDiagonal(this, camera, middle);
    if (asker == Asker::PickerCorner)
    {
      camera->GetFlatQuestions().GetCorner(diagonal, place);
    }
    else
    {
      // as far from the lower corner, whose place the widget has been told
      const double lower[3] = { -1, -1, 2 * z - 1 };
      camera->NDCToWorld(lower, wfv::PictureAspect(this), place);
      place[0] += diagonal;
    }
  }
  x = place[0];
  y = place[1];
  z = place[2];
  return true;
}

void vtkWideFoVRenderer::ViewToWorld(double& x, double& y, double& z)
{
  if (this->AnswerPicker(x, y, z))
  {
    return;
  }
  vtkWideFoVCamera* camera = this->GetWideCamera();
  if (this->HasFlatEye())
  {
    this->ViewToPose(x, y, z);
    this->PoseToWorld(x, y, z);
    return;
  }
  if (!camera)
  {
    this->Superclass::ViewToWorld(x, y, z);
    return;
  }
  this->WatchAreas(camera, x, y, z);
  const double ndc[3] = { x, y, 2 * z - 1 };
  double world[3];
  camera->NDCToWorld(ndc, wfv::PictureAspect(this), world);
  x = world[0];
  y = world[1];
  z = world[2];
}

void vtkWideFoVRenderer::WatchAreas(vtkWideFoVCamera* camera, double x, double y, double z)
{
  if (this->Areas->Ask({ x, y }, z))
  {
    this->WarnOfArea();
    const int* const size = this->GetSize();
    const wfv::vec2 pixel(2.0 / std::max(size[0], 1), 2.0 / std::max(size[1], 1));
    const double aspect = wfv::PictureAspect(this);
    this->Areas->Pending = !this->Areas->IsBetweenPlanes(camera, aspect, pixel);
  }
}

// Not at once: what draws the rectangle to see what is in it asks for its corners as well.
void vtkWideFoVRenderer::WarnOfArea()
{
  if (this->Areas->Pending && wfv::IsNews("area"))
  {
    vtkWarningMacro("what is seen in a large rectangle of a wide picture is not what is between "
                    "planes through its corners: vtkAreaPicker finds other props there than "
                    "vtkRenderedAreaPicker, which finds what is seen");
  }
  this->Areas->Pending = false;
}

bool vtkWideFoVRenderer::DisplayToRay(double x, double y, double origin[3], double direction[3])
{
  vtkWideFoVCamera* camera = vtkWideFoVCamera::SafeDownCast(this->GetActiveCamera());
  if (!camera)
  {
    return false;
  }
  double z = 0;
  this->DisplayToNormalizedDisplay(x, y);
  this->NormalizedDisplayToViewport(x, y);
  this->ViewportToNormalizedViewport(x, y);
  this->NormalizedViewportToView(x, y, z);
  const double ndc[2] = { x, y };
  return camera->NDCToRay(ndc, wfv::PictureAspect(this), origin, direction);
}

void vtkWideFoVRenderer::ResetCamera(const double bounds[6])
{
  this->Superclass::ResetCamera(bounds);
  if (this->IsActiveCameraCreated() && vtkMath::AreBoundsInitialized(bounds))
  {
    std::copy(bounds, bounds + 6, this->LastReset.Bounds);
    this->ActiveCamera->GetPosition(this->LastReset.Position);
    this->LastReset.Asked = false;
  }
}

void vtkWideFoVRenderer::ResetCameraInside()
{
  double bounds[6];
  this->ComputeVisiblePropBounds(bounds);
  if (!vtkMath::AreBoundsInitialized(bounds))
  {
    return;
  }
  vtkCamera* const camera = this->GetActiveCamera();
  double place[3];
  double ahead[3];
  wfv::FindInsidePlace(this, bounds, place);
  camera->GetDirectionOfProjection(ahead);
  // as far as the scene reaches: what VTK measures by the focal distance fits it
  const double length = vtkBoundingBox(bounds).GetDiagonalLength();
  vtkMath::MultiplyScalar(ahead, length > 0 ? length : 1);
  vtkMath::Add(place, ahead, ahead);
  camera->SetPosition(place);
  camera->SetFocalPoint(ahead);
  this->ResetCameraClippingRange(bounds);
  this->InvokeEvent(vtkCommand::ResetCameraEvent, this);
}

void vtkWideFoVRenderer::ResetCameraClippingRange(const double bounds[6])
{
  auto* camera = vtkWideFoVCamera::SafeDownCast(this->ActiveCamera);
  if (camera && camera->GetAutomaticClipRadii())
  {
    camera->ResetClipRadii(bounds);
  }
  if (!this->GetWideCamera())
  {
    this->Superclass::ResetCameraClippingRange(bounds);
  }
}

namespace
{
// Of a picture, what a scene should fill at the least.
constexpr double LeastShare = 0.1;

// How much of the picture a rectangle round the bounds takes.
double ShareOfPicture(vtkWideFoVCamera* camera, double aspect, const double b[6])
{
  double low[2] = { 1, 1 };
  double high[2] = { -1, -1 };
  for (int corner = 0; corner < 8; ++corner)
  {
    const double world[3] = { b[corner % 2], b[2 + corner / 2 % 2], b[4 + corner / 4] };
    double ndc[3];
    camera->WorldToNDC(world, aspect, ndc);
    for (int i = 0; i < 2; ++i)
    {
      low[i] = std::min(low[i], std::max(-1., ndc[i]));
      high[i] = std::max(high[i], std::min(1., ndc[i]));
    }
  }
  return 0.25 * std::max(0., high[0] - low[0]) * std::max(0., high[1] - low[1]);
}

void WarnOfFlatCamera(vtkRenderer* renderer)
{
  if (!vtkWideFoVCamera::SafeDownCast(renderer->GetActiveCamera()) && wfv::IsNews("flat camera"))
  {
    vtkWarningWithObjectMacro(renderer, << "the picture is flat, for the active camera is a "
                                        << renderer->GetActiveCamera()->GetClassName()
                                        << "; set a vtkWideFoVCamera");
  }
}
}

namespace
{
// VTK's exporter of vectors has triangles from their vertices alone.
void WarnOfVectors(vtkRenderer* renderer)
{
  auto* const helper = vtkOpenGLGL2PSHelper::GetInstance();
  if (helper && helper->GetActiveState() == vtkOpenGLGL2PSHelper::Capture &&
    renderer->VisibleActorCount() + renderer->VisibleVolumeCount() > 0 && wfv::IsNews("vectors"))
  {
    vtkWarningWithObjectMacro(renderer, << "what vtkGL2PSExporter makes of a scene in a wide view "
                                        << "is wrong; call Write3DPropsAsRasterImageOn");
  }
}
}

void vtkWideFoVRenderer::ReleaseGraphicsResources(vtkWindow* window)
{
  if (window)
  {
    this->OwnPass->ReleaseGraphicsResources(window); // others may be round it for a frame alone
  }
  this->Superclass::ReleaseGraphicsResources(window);
}

// Warns after ResetCamera alone: a user who places the camera wants the picture that it shows.
void vtkWideFoVRenderer::WarnOfSmallness(vtkWideFoVCamera* camera)
{
  Reset& last = this->LastReset;
  const bool asks =
    !last.Asked && vtkMath::Distance2BetweenPoints(camera->GetPosition(), last.Position) == 0;
  last.Asked = true;
  const double share = asks ? ShareOfPicture(camera, wfv::PictureAspect(this), last.Bounds) : 1;
  if (share < LeastShare && wfv::IsNews("small scene"))
  {
    vtkWarningMacro("the scene fills "
      << 100 * share << " % of the picture, as ResetCamera shows "
      << "it from outside; ResetCameraInside, or widefov-run "
      << "--inside, puts the eye into it, smaller fields of view show it larger");
  }
}

void vtkWideFoVRenderer::DeviceRender()
{
  this->Areas->Pending &= !this->GetSelector();
  this->WarnOfArea();
  vtkWideFoVCamera* const camera = this->GetWideCamera();
  if (!camera || !this->Pass)
  {
    if (this->Pass)
    {
      WarnOfFlatCamera(this);
    }
    this->Superclass::DeviceRender();
    return;
  }
  this->WarnOfSmallness(camera);
  WarnOfVectors(this);
  wfv::PassChain chain;
  vtkRenderPass* const before = this->Pass;
  this->FrameCamera = camera;
  this->Pass = chain.Begin(before, this->OwnPass);
  this->Superclass::DeviceRender();
  this->Pass = before;
  this->FrameCamera = nullptr;
}
