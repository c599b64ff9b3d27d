// SPDX-License-Identifier: BSD-3-Clause
// wfv::Stages: what a view need not draw, and what clusters are classified by.
#include "Frame/Stages.h"

#include "Compat/Reports.h"
#include "Drawables/IndexLimit.h"
#include "Drawables/Kinds/DrawableKinds.h"
#include "Drawables/Volumes.h"
#include "Frame/Technique.h"
#include "vtkWideFoVCamera.h"

#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseVectorKey.h"
#include "vtkMapper.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace
{
// Pixels beyond the window that still count: what rounding, and the chords of the neighbours of
// what is seen, may extend.
constexpr double Margin = 2;

// Of the width of a line or point: how far it may extend, with its corners and beyond a slanting
// border.
constexpr double WidthMargin = 2;

// Mappers whose bounds hold all that they draw, but for the widths of lines and points.
bool KeepsItsBounds(vtkActor* actor)
{
  vtkMapper* const mapper = actor->GetMapper();
  if (!mapper)
  {
    return false;
  }
  vtkProperty* const property = actor->GetProperty();
  return wfv::HasTrait(mapper, wfv::InBounds) && !property->GetRenderLinesAsTubes() &&
    !property->GetRenderPointsAsSpheres();
}

// Lines and points, which are as wide as they are told; of blocks it is not known.
bool DrawsWidths(vtkActor* actor)
{
  auto* const mesh = vtkPolyData::SafeDownCast(actor->GetMapper()->GetInputDataObject(0, 0));
  vtkProperty* const property = actor->GetProperty();
  return !mesh || mesh->GetNumberOfVerts() > 0 || mesh->GetNumberOfLines() > 0 ||
    property->GetRepresentation() != VTK_SURFACE || property->GetEdgeVisibility() ||
    property->GetVertexVisibility();
}

// Corners of the cells of a mesh that counts as one of few triangles.
constexpr vtkIdType FewCorners = 768;

// Number of cells of a surface that has few triangles; 0 if there are more, or none.
vtkIdType CountFew(vtkActor* actor)
{
  vtkMapper* const mapper = actor->GetMapper();
  auto* const mesh = mapper ? vtkPolyData::SafeDownCast(mapper->GetInputDataObject(0, 0)) : nullptr;
  const bool surface = actor->GetProperty()->GetRepresentation() == VTK_SURFACE;
  const bool few = mesh && surface && mesh->GetPolys()->GetNumberOfConnectivityIds() < FewCorners &&
    mesh->GetStrips()->GetNumberOfConnectivityIds() < FewCorners;
  return few ? mesh->GetNumberOfPolys() + mesh->GetNumberOfStrips() : 0;
}
}

namespace
{
// Says so where it is.
bool IsUncountable(vtkActor* actor)
{
  const std::string excess = wfv::FindExcess(wfv::CountIndices(actor));
  if (!excess.empty() && wfv::IsNews("mesh: " + wfv::WithoutNumbers(excess)))
  {
    vtkErrorWithObjectMacro(actor, << "a mesh is not drawn: " << excess);
  }
  return !excess.empty();
}
}

void wfv::Stages::SetPart(vtkRenderer* renderer, const float tile[4])
{
  int size[2];
  int origin[2];
  renderer->GetTiledSizeAndOrigin(&size[0], &size[1], &origin[0], &origin[1]);
  for (int i = 0; i < 2; i++)
  {
    const double pixels = (std::max(1, size[i]) + 2 * this->Border) * static_cast<double>(tile[i]);
    this->Pixels[i] = pixels;
    this->Part.Low[i] = (-1.0 - tile[i + 2]) / tile[i] - this->View.center[i] - 2 * Margin / pixels;
    this->Part.High[i] = (1.0 - tile[i + 2]) / tile[i] - this->View.center[i] + 2 * Margin / pixels;
  }
}

void wfv::Stages::SetEyes(vtkWideFoVCamera* camera, const wfv::StereoModel* stereo)
{
  this->Eye = wfv::FindWorldEye(this->WorldToView);
  // seen from a place so near the origin, a box is one that is so much larger, seen from it
  this->BaselineRadius = stereo && !stereo->Traits.OneCenter ? camera->GetBaselineRadius() : 0;
  if (!stereo || stereo->Traits.StraightRays)
  {
    return;
  }
  // what may be in the picture of either eye, at any depth
  const wfv::Window part = this->Part;
  for (int i = 0; i < 8; i++)
  {
    wfv::WfvView v = this->View;
    v.eye = i & 1 ? wfv::OtherEye(v.eye) : v.eye;
    const wfv::vec2 place = stereo->Unshift(i & 2 ? part.High : part.Low, i & 4 ? 1.0 : -1.0, v);
    this->Part.Low = glm::min(this->Part.Low, place);
    this->Part.High = glm::max(this->Part.High, place);
  }
}

void wfv::Stages::GetToMap(vtkActor* actor, double matrix[16]) const
{
  const double c = this->View.tilt.x;
  const double s = this->View.tilt.y;
  const double tilt[16] = { 1, 0, 0, 0, 0, c, s, 0, 0, -s, c, 0, 0, 0, 0, 1 };
  vtkMatrix4x4::Multiply4x4(tilt, this->WorldToView, matrix);
  if (actor)
  {
    vtkMatrix4x4::Multiply4x4(matrix, &actor->GetMatrix()->Element[0][0], matrix);
  }
}

void wfv::Stages::FindTraits(vtkProp* prop, wfv::PropTraits& traits)
{
  auto* const actor = vtkActor::SafeDownCast(prop);
  if (actor && !traits.Known)
  {
    vtkProperty* const property = actor->GetProperty();
    traits.Bounded = KeepsItsBounds(actor) && !wfv::HasOwnShaders(actor);
    traits.PointSize = property->GetPointSize();
    const double width = std::max<double>(property->GetLineWidth(), traits.PointSize);
    traits.Footprint = traits.Bounded && DrawsWidths(actor) ? WidthMargin * width : 0;
    traits.Few = CountFew(actor);
    traits.Uncountable = IsUncountable(actor);
  }
  traits.Bounded = traits.Bounded || vtkVolume::SafeDownCast(prop);
  traits.Known = true;
}

wfv::Box wfv::Stages::GetBox(const double b[6]) const
{
  double m[16];
  this->GetToMap(nullptr, m);
  wfv::Box box;
  for (int i = 0; i < 8; i++)
  {
    double p[4] = { b[i & 1], b[2 + ((i >> 1) & 1)], b[4 + ((i >> 2) & 1)], 1 };
    vtkMatrix4x4::MultiplyPoint(m, p, p);
    box.Add(wfv::vec3(p[0], p[1], p[2]));
  }
  box.Grow(this->BaselineRadius);
  return box;
}

wfv::Pictures wfv::Stages::GetPictures(const double* b) const
{
  const bool straight = !this->Stereo || this->Stereo->Traits.StraightRays;
  if (b && vtkMath::AreBoundsInitialized(b) && straight)
  {
    const wfv::Box box = this->GetBox(b);
    return wfv::IsBetweenClips(this->View, box)
      ? wfv::PicturesOf(*this->Projection, this->View, box, wfv::vec2(0))
      : wfv::Pictures();
  }
  wfv::Pictures all;
  all.Add(wfv::vec4(-1.0 - this->View.center, 1.0 - this->View.center));
  return all;
}

wfv::vec2 wfv::Stages::GetDistances(const double* b) const
{
  return b && vtkMath::AreBoundsInitialized(b) ? wfv::Distances(this->GetBox(b)) : this->View.radii;
}

bool wfv::Stages::IsLeftOut(vtkProp* prop, wfv::PropTraits& traits) const
{
  FindTraits(prop, traits);
  return traits.Uncountable || wfv::volume::IsFlatVolume(prop);
}

bool wfv::Stages::IsCulled(vtkProp* prop, const double* b, wfv::PropTraits& traits) const
{
  if (this->IsLeftOut(prop, traits))
  {
    return true;
  }
  if (!this->Culling || !traits.Bounded)
  {
    return false;
  }
  if (!b || !vtkMath::AreBoundsInitialized(b))
  {
    return false;
  }
  wfv::Window window = this->Part;
  window.Footprint = traits.Footprint / this->Pixels;
  return wfv::IsCulled(*this->Projection, this->View, this->GetBox(b), window);
}

std::shared_ptr<const wfv::ChordLimits> wfv::Stages::GetLimits(double tolerance)
{
  const wfv::WfvView& a = this->View;
  const wfv::WfvView& b = this->CurvatureView;
  const bool same = this->Curvature && this->CurvatureProjection == this->Projection &&
    a.halfFov == b.halfFov && a.scale == b.scale && a.lens == b.lens && a.lens5 == b.lens5 &&
    a.lensHigh == b.lensHigh && a.center == b.center;
  if (!same)
  {
    this->Curvature = std::make_shared<wfv::LocalCurvature>(*this->Projection, a);
    this->CurvatureView = a;
    this->CurvatureProjection = this->Projection;
  }
  if (!same || this->LimitsPixels != this->Pixels || this->LimitsTolerance != tolerance)
  {
    this->Limits = std::make_shared<wfv::ChordLimits>(
      *this->Projection, this->View, *this->Curvature, this->Pixels, tolerance);
    this->LimitsPixels = this->Pixels;
    this->LimitsTolerance = tolerance;
  }
  return this->Limits;
}

bool wfv::Stages::GetRefineView(
  const vtkWideFoVStage* stage, vtkActor* actor, wfv::RefineView& view)
{
  if (this->Technique == wfv::TechniqueVertex || wfv::HasOwnShaders(actor))
  {
    return false;
  }
  view.Map = this->Projection;
  view.View = this->View;
  view.Part = this->Part;
  view.Pixels = this->Pixels;
  view.Culls = this->Culling;
  view.BaselineRadius = this->BaselineRadius;
  view.Stereo = this->Stereo;
  view.EyeRadius =
    this->Stereo && !this->Stereo->Traits.OneCenter ? wfv::wfvFromMiddle(this->View) : 0;
  view.Tolerance = this->Tolerance;
  const bool refines = this->Refines() && stage == this->Projected;
  view.Limits = refines ? this->GetLimits(this->Tolerance) : nullptr;
  return true;
}

void wfv::Stages::Replace(vtkProp* prop, vtkWideFoVStage* from, vtkWideFoVStage* to)
{
  vtkInformation* const info = prop->GetPropertyKeys();
  vtkInformationObjectBaseVectorKey* const key = vtkOpenGLRenderPass::RenderPasses();
  const int n = info && info->Has(key) ? info->Length(key) : 0;
  for (int i = 0; i < n; i++)
  {
    if (info->Get(key, i) == from)
    {
      info->Set(key, to, i);
    }
  }
}
