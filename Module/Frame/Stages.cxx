// SPDX-License-Identifier: BSD-3-Clause
#include "Frame/Stages.h"

#include "Camera/Tile.h"
#include "Drawables/Discontinuity.h"
#include "Drawables/FatMesh.h"
#include "Drawables/Sky.h"
#include "Frame/Technique.h"
#include "vtkWideFoVCamera.h"

#include "vtkActor.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseVectorKey.h"
#include "vtkMapper.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPolyData.h"
#include "vtkProp.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"

#include <algorithm>
#include <cmath>

namespace
{
// Runs of the geometry stage for each of few triangles: more make tighter shapes, but each run, and
// each border between two columns of pixels, takes time as well.
constexpr int RunsOfFew = 3;

// Pixels that each of these is to take up, or its runs cost more than tight shapes save.
constexpr double CoarsePixels = 1024;

// Factor: how much larger than the mean a pixel's angle may be somewhere in a map.
constexpr double PixelSafety = 8;
}

wfv::Stages::Stages()
{
  this->PreClip->SetVariant(wfv::ShaderBuilder::Variant::PreClip);
  this->Exact->SetVariant(wfv::ShaderBuilder::Variant::Exact);
  this->ExactInSingle->SetVariant(wfv::ShaderBuilder::Variant::Exact);
  this->ExactInSingle->SetRuns(RunsOfFew);
  this->Sky->SetVariant(wfv::ShaderBuilder::Variant::Sky);
}

std::array<vtkWideFoVStage*, 5> wfv::Stages::GetAll()
{
  return { this->Projected, this->PreClip, this->Exact, this->ExactInSingle, this->Sky };
}

void wfv::Stages::Begin(
  vtkRenderer* renderer, vtkWideFoVCamera* camera, int technique, double tolerance)
{
  this->Technique = technique;
  const wfv::View& view = camera->GetView(wfv::PictureAspect(renderer));
  this->Projection = &view.GetProjection();
  const wfv::StereoModel* const stereo = view.GetStereoModel();
  this->Stereo = stereo;
  this->ByPixels = stereo && !(stereo->Traits.OneCenter && stereo->Traits.StraightRays);
  this->Tolerance = tolerance;
  const int* const drawn = renderer->GetSize();
  const int size[2] = { this->Enlargement * drawn[0], this->Enlargement * drawn[1] };
  this->HalfDiagonal = 0.5 * std::hypot(size[0], size[1]);
  this->View = view.GetParameters();
  this->PixelAngle = 2 * std::max(this->View.halfFov.x, this->View.halfFov.y) /
    std::max(1, std::min(size[0], size[1]));
  vtkMatrix4x4::DeepCopy(this->WorldToView, camera->GetModelViewTransformMatrix());
  if (auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow()))
  {
    this->Textures.Load(this->View.map, window);
  }
  for (vtkWideFoVStage* const stage : this->GetAll())
  {
    stage->SetView(renderer, camera, tolerance, this->Border);
    stage->SetTextures(&this->Textures);
    stage->SetStages(this);
    this->Instruct(stage);
    stage->ResetNumberOfDraws();
  }
  this->SetPart(renderer, this->Projected->GetTile());
  this->SetEyes(camera, stereo);
  this->Fine.Begin(renderer);
  this->Counts = wfv::FrameStatistics();
  this->DrawnKeys.clear();
  this->Programs.BeginFrame();
  this->NumberView(stereo);
}

// How a stage draws triangles and lines, by the technique, its tolerance and the eyes.
void wfv::Stages::Instruct(vtkWideFoVStage* stage)
{
  const bool automatic = this->Technique == wfv::TechniqueAuto;
  stage->SetClipless(this->Technique == wfv::TechniqueVertex);
  stage->SetByRays(automatic);
  using Variant = wfv::ShaderBuilder::Variant;
  stage->SetUnrefined(!this->Refines() ? stage->GetVariant()
      : this->ByPixels                 ? Variant::Exact
                                       : Variant::PreClip);
  stage->SetFp64(this->IsExact() && stage != this->ExactInSingle);
  stage->SetChordLines(automatic);
}

void wfv::Stages::SetDebugView(bool debugView)
{
  for (vtkWideFoVStage* const stage : this->GetAll())
  {
    stage->SetDebugView(debugView);
  }
}

bool wfv::Stages::IsExactTechnique(int technique, double tolerance)
{
  return technique == wfv::TechniqueExact ||
    (technique == wfv::TechniqueAuto && !AllowsChords(tolerance));
}

bool wfv::Stages::IsExact() const
{
  return IsExactTechnique(this->Technique, this->Tolerance);
}

// Few triangles that take up many pixels each: by the sphere round the prop, as it is seen.
bool wfv::Stages::IsCoarse(const double* bounds, const wfv::PropTraits& traits) const
{
  if (traits.Few == 0 || !bounds || !vtkMath::AreBoundsInitialized(bounds))
  {
    return false;
  }
  const wfv::vec3 low(bounds[0], bounds[2], bounds[4]);
  const wfv::vec3 high(bounds[1], bounds[3], bounds[5]);
  const wfv::vec3 eye(this->Eye.Place[0], this->Eye.Place[1], this->Eye.Place[2]);
  const double sine = 0.5 * glm::length(high - low) / glm::length(0.5 * (low + high) - eye);
  const double angle = sine < 1 ? std::asin(sine) : vtkMath::Pi(); // from inside too
  const double across = 2 * angle / this->PixelAngle;
  return across * across >= CoarsePixels * static_cast<double>(traits.Few);
}

// Asked of few triangles alone: of more it would take long.
bool wfv::Stages::IsFat(vtkProp* prop, const double* bounds, const wfv::PropTraits& traits) const
{
  const bool asked = this->IsExact() && this->IsCoarse(bounds, traits);
  auto* const actor = asked ? vtkActor::SafeDownCast(prop) : nullptr;
  vtkMapper* const mapper = actor ? actor->GetMapper() : nullptr;
  auto* const mesh = mapper ? vtkPolyData::SafeDownCast(mapper->GetInputDataObject(0, 0)) : nullptr;
  double toMap[16];
  this->GetToMap(actor, toMap);
  return mesh && wfv::IsFat(mesh, toMap);
}

// A direction map has no chords that something could be said of.
bool wfv::Stages::Refines() const
{
  return this->Technique == wfv::TechniqueAuto && AllowsChords(this->Tolerance) &&
    this->Projection->Axis != wfv::Family::Sampled;
}

double wfv::Stages::GetPointFootprint(const wfv::PropTraits& traits) const
{
  const double pixels = traits.PointSize;
  return pixels > 1 ? 0.5 * pixels * PixelSafety * this->PixelAngle : 0;
}

vtkWideFoVStage* wfv::Stages::Choose(vtkProp* prop, const double* bounds, wfv::PropTraits& traits)
{
  if (wfv::sky::Is(prop))
  {
    return this->Sky;
  }
  FindTraits(prop, traits);
  if (!traits.Prepared)
  {
    this->Buffers.Prepare(prop);
    traits.Prepared = true;
  }
  // a volume has no primitives: every pixel has its ray, whatever the technique
  if (this->Technique == wfv::TechniqueVertex || vtkVolume::SafeDownCast(prop))
  {
    return this->Projected;
  }
  if (this->Refines())
  {
    return this->Projected;
  }
  const bool sampled = this->Projection->Axis == wfv::Family::Sampled;
  const bool covers = this->IsExact() || sampled;
  if (covers || this->ByPixels)
  {
    return this->IsFat(prop, bounds, traits) ? this->ExactInSingle : this->Exact;
  }
  if (!bounds || !vtkMath::AreBoundsInitialized(bounds))
  {
    return this->PreClip;
  }
  return this->ChooseByBounds(bounds, traits);
}

vtkWideFoVStage* wfv::Stages::ChooseByBounds(const double bounds[6], const wfv::PropTraits& traits)
{
  const bool discontinuous = vtkWideFoVNeedsPreClip(
    *this->Projection, this->View, bounds, this->WorldToView, this->GetPointFootprint(traits));
  return discontinuous ? this->PreClip : this->Projected;
}

vtkWideFoVStage* wfv::Stages::FindAttached(vtkProp* prop)
{
  vtkInformation* const info = prop->GetPropertyKeys();
  vtkInformationObjectBaseVectorKey* const key = vtkOpenGLRenderPass::RenderPasses();
  const int n = info ? info->Length(key) : 0;
  for (int i = 0; i < n; i++)
  {
    if (auto* const stage = vtkWideFoVStage::SafeDownCast(info->Get(key, i)))
    {
      return stage;
    }
  }
  return nullptr;
}
