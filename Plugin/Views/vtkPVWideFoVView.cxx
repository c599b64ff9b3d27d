// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPVWideFoVView.h"

#include "DirectionFile.h"
#include "GridAxesActor.h"
#include "Projections/Projection.h"
#include "Stereo/Stereo.h"
#include "vtkPVWideFoVViewInternals.h"
#include "vtkWideFoVOverrides.h"

#include "vtkBoundingBox.h"
#include "vtkCommand.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLCamera.h"
#include "vtkPVAxesWidget.h"
#include "vtkPVDataRepresentation.h"
#include "vtkPVSynchronizedRenderer.h"
#include "vtkProp.h"
#include "vtkPropCollection.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkSynchronizedRenderers.h"

#include <algorithm>
#include <array>
#include <string>

namespace
{
// The order of a renderer's observers: behind that which receives the client's camera.
constexpr float AfterSynchronizer = -1.0f;

// What is no data, and may stand out of it, has to be between the clip spheres as well.
bool IsAnnotation(vtkProp* prop)
{
  return wfvplugin::GridAxesActor::SafeDownCast(prop) || prop->IsA("vtkPolarAxesActor") ||
    prop->IsA("vtkFlagpoleLabel");
}

void AddAnnotations(vtkRenderer* renderer, vtkBoundingBox& box)
{
  vtkPropCollection* const props = renderer->GetViewProps();
  vtkCollectionSimpleIterator it;
  props->InitTraversal(it);
  while (vtkProp* const prop = props->GetNextProp(it))
  {
    const double* const bounds =
      prop->GetVisibility() && IsAnnotation(prop) ? prop->GetBounds() : nullptr;
    if (bounds && vtkMath::AreBoundsInitialized(bounds))
    {
      box.AddBounds(bounds);
    }
  }
}
}

// Not the standard macro: the renderers are made by the superclass's constructor.
vtkPVWideFoVView* vtkPVWideFoVView::New()
{
  vtkWideFoVOverrides wide;
  auto* view = new vtkPVWideFoVView;
  view->InitializeObjectBase();
  return view;
}

vtkPVWideFoVView::vtkPVWideFoVView()
  : Internal(new Internals)
{
  Internals& in = *this->Internal;
  in.Pass->SetDelegatePass(in.Delegate);
  // frames of several ranks become smaller by ParaView's own factor, all of them alike
  in.Pass->SetKeepUpdateRate(wfvplugin::HasOneRank());
  const wfv::Projection& map = in.Stereo->GetProjectionDefinition();
  in.Stereo->SetStereoModel(wfv::UsualStereo(map).Name.c_str());
  in.Reduced->SetDelegatePass(in.Pass);
  this->SynchronizedRenderers->SetRenderPass(in.Reduced);
  // a compass is no part of the scene
  vtkSmartPointer<vtkCamera> plain;
  plain.TakeReference(vtkOpenGLCamera::New());
  this->OrientationWidget->GetRenderer()->SetActiveCamera(plain);
  this->OrientationWidget->GetRenderer()->SetPass(nullptr);

  this->GetRenderer()->AddViewProp(in.Everywhere);
  this->GetRenderer()->AddObserver(
    vtkCommand::StartEvent, this, &vtkPVWideFoVView::StartFrame, AfterSynchronizer);
  this->GetRenderer()->AddObserver(vtkCommand::EndEvent, this, &vtkPVWideFoVView::EndFrame);
  this->AddObserver(vtkCommand::ResetCameraEvent, this, &vtkPVWideFoVView::PlaceFirstEye);
  this->UpdateCamera();
}

vtkPVWideFoVView::~vtkPVWideFoVView()
{
  if (vtkRenderWindow* window = this->GetRenderWindow())
  {
    this->Internal->Pass->ReleaseGraphicsResources(window);
  }
}

void vtkPVWideFoVView::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const Internals& in = *this->Internal;
  os << indent << "Projection: " << in.Projection << "\n"
     << indent << "HorizontalFieldOfView: " << in.HorizontalFov << "\n"
     << indent << "VerticalFieldOfView: " << in.VerticalFov << "\n"
     << indent << "Tilt: " << in.Tilt << "\n"
     << indent << "DirectionMapFile: " << in.DirectionMapFile << "\n"
     << indent << "AutomaticClipSpheres: " << in.AutomaticClipSpheres << "\n"
     << indent << "ClipSpheres: " << in.ClipSpheres[0] << ", " << in.ClipSpheres[1] << "\n"
     << indent << "DepthMapping: " << in.DepthMapping << "\n"
     << indent << "StereoModel: " << in.Stereo->GetStereoModel() << "\n"
     << indent << "Pass:\n";
  in.Pass->PrintSelf(os, indent.GetNextIndent());
}

void vtkPVWideFoVView::SetProjection(const char* name)
{
  const std::string wanted = name ? name : "";
  if (wanted == this->Internal->Projection)
  {
    return;
  }
  // the camera knows the names, and says so in an error
  vtkNew<vtkWideFoVCamera> trial;
  trial->SetProjection(wanted.c_str());
  if (wanted == trial->GetProjection())
  {
    this->Internal->Projection = wanted;
    this->UpdateCamera();
  }
}

void vtkPVWideFoVView::SetHorizontalFieldOfView(double degrees)
{
  this->Internal->HorizontalFov = degrees;
  this->UpdateCamera();
}

void vtkPVWideFoVView::SetVerticalFieldOfView(double degrees)
{
  this->Internal->VerticalFov = degrees;
  this->UpdateCamera();
}

void vtkPVWideFoVView::SetTilt(double degrees)
{
  this->Internal->Tilt = degrees;
  this->UpdateCamera();
}

void vtkPVWideFoVView::SetLens(double c1, double c2, double c3, double c4, double c5)
{
  this->Internal->Lens = { { c1, c2, c3, c4, c5 } };
  this->UpdateCamera();
}

void vtkPVWideFoVView::SetDirectionMapFile(const char* path)
{
  const std::string wanted = path ? path : "";
  Internals& in = *this->Internal;
  if (wanted == in.DirectionMapFile)
  {
    return;
  }
  try
  {
    in.DirectionMap = wanted.empty() ? nullptr : wfvplugin::ReadDirectionFile(wanted);
    in.DirectionMapFile = wanted;
  }
  catch (const std::exception& e)
  {
    vtkErrorMacro(<< e.what());
  }
  this->UpdateCamera();
}

void vtkPVWideFoVView::SetAutomaticClipSpheres(bool automatic)
{
  this->Internal->AutomaticClipSpheres = automatic;
  this->UpdateCamera();
}

void vtkPVWideFoVView::SetClipSpheres(double nearRadius, double farRadius)
{
  // a camera knows which are none; said here, and not anew by every frame
  vtkNew<vtkWideFoVCamera> trial;
  trial->SetClipRadii(nearRadius, farRadius);
  if (trial->GetNearClipRadius() == nearRadius && trial->GetFarClipRadius() == farRadius)
  {
    this->Internal->ClipSpheres = { { nearRadius, farRadius } };
    this->UpdateCamera();
  }
}

void vtkPVWideFoVView::SetDepthMapping(int mapping)
{
  this->Internal->DepthMapping = mapping;
  this->UpdateCamera();
}

void vtkPVWideFoVView::SetTechnique(int technique)
{
  this->Internal->Pass->SetTechnique(technique);
  this->UpdateCamera();
}

void vtkPVWideFoVView::SetTolerance(double pixels)
{
  this->Internal->Pass->SetTolerance(pixels);
  this->UpdateCamera();
}

void vtkPVWideFoVView::SetActiveCamera(vtkCamera* camera)
{
  this->Superclass::SetActiveCamera(camera);
  this->UpdateCamera();
}

void vtkPVWideFoVView::UpdateCamera()
{
  auto* camera = vtkWideFoVCamera::SafeDownCast(this->GetActiveCamera());
  if (!camera)
  {
    return;
  }
  const Internals& in = *this->Internal;
  camera->SetProjection(in.Projection.c_str());
  // a default of 180 degrees is no mistake of whoever chose Mercator
  const wfv::Projection& map = camera->GetProjectionDefinition();
  camera->SetHorizontalFieldOfView(
    std::clamp(in.HorizontalFov, map.MinHorizontalFov, map.MaxHorizontalFov));
  camera->SetVerticalFieldOfView(
    std::clamp(in.VerticalFov, map.MinVerticalFov, map.MaxVerticalFov));
  camera->SetTilt(in.Tilt);
  camera->SetDirectionMap(in.DirectionMap);
  camera->SetDepthMapping(in.DepthMapping);
  camera->SetExactPerspective(in.Pass->IsExact());
  std::array<double, 5> lens;
  camera->GetLens(lens.data());
  if (in.Lens == std::array<double, 5>{} && lens != in.Lens)
  {
    camera->ClearLens();
  }
  else if (lens != in.Lens)
  {
    camera->SetLens(in.Lens[0], in.Lens[1], in.Lens[2], in.Lens[3], in.Lens[4]);
  }
  this->UpdateStereo();
  // by the bounds of all ranks, not by those of the props that this one has
  camera->AutomaticClipRadiiOff();
  this->UpdateClipSpheres();
}

void vtkPVWideFoVView::UpdateClipSpheres()
{
  auto* camera = vtkWideFoVCamera::SafeDownCast(this->GetActiveCamera());
  if (!camera)
  {
    return;
  }
  const Internals& in = *this->Internal;
  if (!in.AutomaticClipSpheres)
  {
    camera->SetClipRadii(in.ClipSpheres[0], in.ClipSpheres[1]);
    return;
  }
  vtkBoundingBox box = this->GeometryBounds;
  AddAnnotations(this->GetRenderer(), box);
  if (box.IsValid())
  {
    double bounds[6];
    box.GetBounds(bounds);
    camera->ResetClipRadii(bounds);
  }
}

bool vtkPVWideFoVView::GetMiddleOfData(double middle[3])
{
  // ParaView gives an empty view the bounds of a cube
  bool valid = false;
  for (int i = 0; i < this->GetNumberOfRepresentations(); ++i)
  {
    auto* const data = vtkPVDataRepresentation::SafeDownCast(this->GetRepresentation(i));
    valid |= data && data->GetVisibility() && this->GeometryBounds.IsValid();
  }
  if (valid)
  {
    this->GeometryBounds.GetCenter(middle);
  }
  return valid;
}

void vtkPVWideFoVView::PlaceFirstEye()
{
  constexpr double HalfSphere = 180; // degrees: less is what is ahead, of which one stands back
  auto* const camera = vtkWideFoVCamera::SafeDownCast(this->GetActiveCamera());
  double middle[3];
  if (this->Internal->DataDrawn || !camera || !camera->IsWide() ||
    camera->GetHorizontalFieldOfView() <= HalfSphere || !this->GetMiddleOfData(middle))
  {
    return;
  }
  double ahead[3];
  camera->GetDirectionOfProjection(ahead);
  vtkMath::MultiplyScalar(ahead, camera->GetDistance());
  vtkMath::Add(middle, ahead, ahead);
  camera->SetPosition(middle);
  camera->SetFocalPoint(ahead);
  this->ResetCameraClippingRange();
}

void vtkPVWideFoVView::ResetCameraClippingRange()
{
  this->Superclass::ResetCameraClippingRange();
  this->UpdateClipSpheres();
}

void vtkPVWideFoVView::AboutToRenderOnLocalProcess(bool interactive)
{
  this->Superclass::AboutToRenderOnLocalProcess(interactive);
  this->UpdateReduction();
  for (const std::string& line : this->Internal->Undrawn.Look(this->GetRenderer()))
  {
    vtkWarningMacro(<< line);
  }
}

void vtkPVWideFoVView::UpdateReduction()
{
  vtkSynchronizedRenderers* const ranks = this->SynchronizedRenderers->GetParallelSynchronizer();
  if (!ranks || !ranks->IsA("vtkIceTSynchronizedRenderers"))
  {
    return; // others do without a matrix
  }
  int tiles[2];
  this->GetRenderWindow()->GetTileScale(tiles);
  if (this->GetMakingSelection() || tiles[0] > 1 || tiles[1] > 1)
  {
    // a selection asks for pixels of the window, and a tile is a corner already
    this->SynchronizedRenderers->SetImageReductionFactor(1);
  }
  this->Internal->Reduced->SetFactor(this->SynchronizedRenderers->GetImageReductionFactor());
}

void vtkPVWideFoVView::StartFrame()
{
  this->UpdateStereo();
  double middle[3];
  this->Internal->DataDrawn |= this->GetMiddleOfData(middle);
  this->Internal->Texts.BeginBounds(this->GetRenderer());
  this->UpdateClipSpheres();
  this->Internal->Texts.EndBounds();
  this->Internal->Instead.Begin(this->GetRenderer());
  this->Internal->Everywhere->UseBoundsOn();
  this->Internal->Threads.Begin();
}

void vtkPVWideFoVView::EndFrame()
{
  this->Internal->Threads.End();
  this->Internal->Everywhere->UseBoundsOff();
  this->Internal->Instead.End();
}
