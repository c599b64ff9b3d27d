// SPDX-License-Identifier: BSD-3-Clause
// vtkWideFoVCamera: the view as others ask for it.
#include "vtkWideFoVCamera.h"

#include "Camera/CameraInternals.h"
#include "Camera/Tile.h"
#include "Projections/DirectionMap.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkMatrix3x3.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkPerspectiveTransform.h"
#include "vtkPointData.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

const wfv::Projection& vtkWideFoVCamera::GetProjectionDefinition()
{
  return *this->Definition;
}

const wfv::Projection& vtkWideFoVCamera::GetDrawnProjection()
{
  const bool framed = this->ExactPerspective && this->Definition->Axis == wfv::Family::Planar &&
    !this->GetFittingModel() && wfv::FitsFrame(this->Internal->Options);
  return framed ? wfv::FramedPerspective() : *this->Definition;
}

bool vtkWideFoVCamera::IsWide()
{
  return this->GetDrawnProjection().Axis != wfv::Family::Planar;
}

void vtkWideFoVCamera::GetViewpoint(double world[3])
{
  this->GetPosition(world);
}

bool vtkWideFoVCamera::SetDirectionMap(vtkImageData* directions)
{
  if (!directions)
  {
    this->SetDirectionMap(std::shared_ptr<const wfv::DirectionMap>());
    return true;
  }
  const int* const size = directions->GetDimensions();
  vtkDataArray* const scalars = directions->GetPointData()->GetScalars();
  std::vector<float> values;
  if (scalars && scalars->GetNumberOfComponents() == 3 && size[2] == 1)
  {
    for (vtkIdType i = 0; i < scalars->GetNumberOfTuples(); i++)
    {
      for (int c = 0; c < 3; c++)
      {
        values.push_back(static_cast<float>(scalars->GetComponent(i, c)));
      }
    }
  }
  const std::string problem = wfv::DirectionMap::Check(size[0], size[1], values);
  if (!problem.empty())
  {
    vtkErrorMacro(<< "The direction map is refused: " << problem);
    return false;
  }
  this->SetDirectionMap(std::make_shared<const wfv::DirectionMap>(size[0], size[1], values));
  return true;
}

void vtkWideFoVCamera::SetDirectionMap(const std::shared_ptr<const wfv::DirectionMap>& map)
{
  if (map != this->Internal->Options.Map)
  {
    this->Internal->Options.Map = map;
    this->Modified();
  }
}

bool vtkWideFoVCamera::HasDirectionMap()
{
  return this->Internal->Options.Map != nullptr;
}

const wfv::View& vtkWideFoVCamera::GetView(double aspect)
{
  Internals& in = *this->Internal;
  const wfv::Eye eye = static_cast<wfv::Eye>(this->GetCurrentEye());
  if (!in.Cache || in.CacheAspect != aspect || in.CacheTime < this->GetMTime() ||
    in.CacheEye != eye)
  {
    wfv::ViewOptions options = in.Options;
    options.Aspect = aspect;
    options.Stereo.Eye = eye;
    options.Stereo.Model = this->GetFittingModel();
    const double rim = vtkMath::RadiansFromDegrees(0.5 * options.HorizontalFov);
    if (!this->Definition->HasLens ||
      (options.Lens[0] != 0 && !wfv::LensFits(*this->Definition, options.Lens, rim)))
    {
      options.Lens.fill(0); // it is that of another projection
    }
    in.Cache.emplace(this->GetDrawnProjection(), options);
    in.CacheAspect = aspect;
    in.CacheEye = eye;
    in.CacheTime = this->GetMTime();
  }
  return *in.Cache;
}

bool vtkWideFoVCamera::WorldToNDC(const double world[3], double aspect, double ndc[3])
{
  double p[4] = { world[0], world[1], world[2], 1 };
  this->GetModelViewTransformMatrix()->MultiplyPoint(p, p);
  const wfv::NdcPoint q = this->GetView(aspect).Forward(wfv::vec3(p[0], p[1], p[2]));
  ndc[0] = q.Ndc.x;
  ndc[1] = q.Ndc.y;
  ndc[2] = q.Ndc.z;
  return q.Inside;
}

bool vtkWideFoVCamera::NDCToWorld(const double ndc[3], double aspect, double world[3])
{
  const wfv::View& view = this->GetView(aspect);
  const wfv::ViewRay ray = view.RayAt(wfv::vec3(ndc[0], ndc[1], ndc[2]));
  double origin[3];
  double direction[3];
  this->ToWorld(ray, origin, direction);
  const double rho = wfv::wfvDistanceAt(0.5 * (ndc[2] + 1), view.GetParameters());
  for (int i = 0; i < 3; i++)
  {
    world[i] = origin[i] + rho * direction[i];
  }
  return ray.Inside;
}

void vtkWideFoVCamera::ToWorld(const wfv::ViewRay& ray, double origin[3], double direction[3])
{
  double o[4] = { ray.Origin.x, ray.Origin.y, ray.Origin.z, 1 };
  double d[4] = { ray.Direction.x, ray.Direction.y, ray.Direction.z, 0 };
  vtkNew<vtkMatrix4x4> inverse;
  vtkMatrix4x4::Invert(this->GetModelViewTransformMatrix(), inverse);
  inverse->MultiplyPoint(o, o);
  inverse->MultiplyPoint(d, d);
  vtkMath::Normalize(d);
  std::copy_n(o, 3, origin);
  std::copy_n(d, 3, direction);
}

bool vtkWideFoVCamera::NDCToRay(
  const double ndc[2], double aspect, double origin[3], double direction[3])
{
  const wfv::ViewRay ray = this->GetView(aspect).Ray(wfv::vec2(ndc[0], ndc[1]));
  this->ToWorld(ray, origin, direction);
  return ray.Inside;
}

thread_local int vtkWideFoVCamera::Internals::FramesInDrawing = 0;

void vtkWideFoVCamera::BeginFrame(
  vtkRenderer* renderer, const double* bounds, const int* framebuffer)
{
  this->EndFrame(); // one that an exception has cut short
  this->Internal->Framebuffer = { framebuffer ? framebuffer[0] : 0,
    framebuffer ? framebuffer[1] : 0 };
  this->Internal->Bounds = bounds;
  this->PrepareFrame(renderer);
  this->Internal->Bounds = nullptr;
  this->Internal->InFrame = true;
  Internals::FramesInDrawing++;
}

void vtkWideFoVCamera::EndFrame()
{
  Internals::FramesInDrawing -= this->Internal->InFrame ? 1 : 0;
  this->Internal->InFrame = false;
  this->Internal->Framebuffer = { 0, 0 };
}

void vtkWideFoVCamera::PrepareFrame(vtkRenderer* renderer)
{
  if (this->Internal->InFrame)
  {
    return;
  }
  this->WarnOfWhatIsIgnored(renderer);
  this->FindEye(renderer);
  this->FindPart(renderer);
  this->FitClipRadii(renderer);
}

void vtkWideFoVCamera::FindPart(vtkRenderer* renderer)
{
  if (this->IsWide() || !renderer->GetVTKWindow())
  {
    return;
  }
  const wfv::TilePixels pixels = wfv::PixelsOfTile(renderer);
  std::array<double, 4> part;
  for (int i = 0; i < 2; i++)
  {
    part[2 * i] = 2 * pixels.Start[i] / pixels.Full[i] - 1;
    part[2 * i + 1] = 2 * (pixels.Start[i] + pixels.Size[i]) / pixels.Full[i] - 1;
  }
  if (part != this->Internal->Part)
  {
    this->Internal->Part = part;
    this->Modified();
  }
}

void vtkWideFoVCamera::Render(vtkRenderer* renderer)
{
  this->PrepareFrame(renderer);
  this->Superclass::Render(renderer);
  // which cleared the renderer's part of the window
  if (this->TakeFramebuffer(renderer) && renderer->GetRenderWindow()->GetErase() &&
    renderer->GetErase())
  {
    renderer->Clear();
  }
}

bool vtkWideFoVCamera::TakeFramebuffer(vtkRenderer* renderer)
{
  const std::array<int, 2>& size = this->Internal->Framebuffer;
  auto* const window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  if (size[0] <= 0 || !window)
  {
    return false;
  }
  window->GetState()->vtkglViewport(0, 0, size[0], size[1]);
  window->GetState()->vtkglScissor(0, 0, size[0], size[1]);
  return true;
}

void vtkWideFoVCamera::UpdateViewport(vtkRenderer* renderer)
{
  this->PrepareFrame(renderer);
  this->Superclass::UpdateViewport(renderer);
  this->TakeFramebuffer(renderer);
}

namespace
{
// Normalized device coordinates: far beyond the window, and a float32.
constexpr double Outside = 1e30;

// Whether the program that is in use has a stage: some ask for the matrices twice.
bool HasStage(vtkRenderer* renderer)
{
  auto* const window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  vtkShaderProgram* const program =
    window ? window->GetShaderCache()->GetLastShaderBound() : nullptr;
  const char* const names[] = { "wfvTile", "wfvViewport", "wfvPicture", "wfvView.radii" };
  return program && std::any_of(std::begin(names), std::end(names), [program](const char* name) {
    return program->IsUniformUsed(name);
  });
}
}

void vtkWideFoVCamera::GetKeyMatrices(vtkRenderer* renderer, vtkMatrix4x4*& wcvc,
  vtkMatrix3x3*& normals, vtkMatrix4x4*& vcdc, vtkMatrix4x4*& wcdc)
{
  this->Superclass::GetKeyMatrices(renderer, wcvc, normals, vcdc, wcdc);
  if (!this->IsWide())
  {
    return;
  }
  // Stock mappers then write view coordinates to gl_Position; the stages that the
  // pass adds do the rest.
  vcdc->Identity();
  wcdc->DeepCopy(wcvc);
  Internals& in = *this->Internal;
  if (!in.Staged && !HasStage(renderer))
  {
    in.FlatDraws++;
    vcdc->SetElement(3, 0, Outside); // as OpenGL takes them, transposed
    wcdc->SetElement(3, 0, Outside);
    this->WarnOfFlatRenderer(renderer);
  }
  in.Staged = false;
}

void vtkWideFoVCamera::ExpectStage()
{
  this->Internal->Staged = true;
}

int vtkWideFoVCamera::TakeFlatDraws()
{
  const int taken = this->Internal->FlatDraws;
  this->Internal->FlatDraws = 0;
  this->Internal->Staged = false;
  return taken;
}

namespace
{
// Two frusta lie in the one with its apex behind the line of the eyes. tx, ty: tangents of half the
// field of view; near: distance of the near plane from that line.
void AddFrustumOfBothEyes(
  vtkPerspectiveTransform* transform, const wfv::ViewOptions& o, double tx, double ty, double near)
{
  const double s = o.Stereo.Separation;
  const double back = o.Stereo.Convergence * s / (1 + s);
  const double n = near + back;
  const double x = n * tx * (1 + s);
  transform->Frustum(-x, x, -n * ty, n * ty, n, o.Radii[1] + back);
  transform->Translate(0, 0, -back);
  transform->RotateX(-o.Tilt);
}
}

void vtkWideFoVCamera::ComputeProjectionTransform(double aspect, double nearz, double farz)
{
  if (this->IsWide())
  {
    this->Superclass::ComputeProjectionTransform(aspect, nearz, farz);
    return;
  }
  // The planes touch the clip spheres: near at the corner of the picture, far on the axis.
  const wfv::ViewOptions& o = this->Internal->Options;
  const double tx = std::tan(vtkMath::RadiansFromDegrees(0.5 * o.HorizontalFov));
  const double ty = std::tan(vtkMath::RadiansFromDegrees(0.5 * o.VerticalFov));
  const double cornerX = tx * (1 + std::abs(o.Center.x));
  const double cornerY = ty * (1 + std::abs(o.Center.y));
  const double n = o.Radii[0] / std::sqrt(1 + cornerX * cornerX + cornerY * cornerY);
  this->ProjectionTransform->Identity();
  if (const std::array<double, 4>& part = this->Internal->Part; !this->Internal->ForBothEyes)
  {
    this->ProjectionTransform->AdjustViewport(part[0], part[1], part[2], part[3], -1, 1, -1, 1);
  }
  this->ProjectionTransform->AdjustZBuffer(-1, +1, nearz, farz);
  if (this->Internal->ForBothEyes)
  {
    AddFrustumOfBothEyes(this->ProjectionTransform, o, tx, ty, n);
    return;
  }
  double eye;
  double shift;
  this->GetFlatEye(tx, eye, shift);
  const wfv::vec2 center = o.Center + wfv::vec2(shift, 0);
  this->ProjectionTransform->Frustum(-n * tx * (1 + center.x), n * tx * (1 - center.x),
    -n * ty * (1 + center.y), n * ty * (1 - center.y), n, o.Radii[1]);
  this->ProjectionTransform->Translate(-eye, 0, 0);
  this->ProjectionTransform->RotateX(-o.Tilt);
}

void vtkWideFoVCamera::SetFrustum(const double half[2], const double center[2])
{
  wfv::ViewOptions& o = this->Internal->Options;
  const double horizontal = 2 * vtkMath::DegreesFromRadians(std::atan(half[0]));
  const double vertical = 2 * vtkMath::DegreesFromRadians(std::atan(half[1]));
  const wfv::vec2 middle(center[0], center[1]);
  if (horizontal != o.HorizontalFov || vertical != o.VerticalFov || middle != o.Center)
  {
    o.HorizontalFov = horizontal;
    o.VerticalFov = vertical;
    o.Center = middle;
    this->Modified();
  }
}

void vtkWideFoVCamera::GetFrustumPlanes(double aspect, double planes[24])
{
  if (!this->IsWide())
  {
    this->GetFrustumPlanesOfBoth(aspect, planes);
    return;
  }
  // Six planes that everything is in front of: cullers that think in a linear
  // frustum must drop nothing.
  std::fill_n(planes, 24, 0.0);
  for (int i = 0; i < 6; i++)
  {
    planes[4 * i + 3] = std::numeric_limits<float>::max();
  }
}
