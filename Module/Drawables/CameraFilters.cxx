// SPDX-License-Identifier: BSD-3-Clause
#include "Drawables/CameraFilters.h"

#include "Camera/PictureScale.h"
#include "Compat/Reports.h"
#include "Drawables/Kinds/DrawableKinds.h"
#include "vtkWideFoVCamera.h"

#include "vtkAlgorithm.h"
#include "vtkCommand.h"
#include "vtkDataArray.h"
#include "vtkDistanceToCamera.h"
#include "vtkMapper.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace
{
// The size of a pixel at a place for a filter that takes the picture for a perspective.
double FlatPixelSize(vtkRenderer* renderer, vtkWideFoVCamera* camera, const double place[3])
{
  double eye[3];
  camera->GetPosition(eye);
  const double distance = std::sqrt(vtkMath::Distance2BetweenPoints(place, eye));
  const double angle = vtkMath::RadiansFromDegrees(camera->GetViewAngle());
  return distance * 2 * std::tan(0.5 * angle) / std::max(renderer->GetSize()[1], 1);
}

// Sizes what a vtkDistanceToCamera has just made by the pixels of the wide view. In any other view
// it leaves it alone.
class Sizer : public vtkCommand
{
public:
  static Sizer* New() { return new Sizer; }

  void Execute(vtkObject* caller, unsigned long, void*) override
  {
    auto* const filter = vtkDistanceToCamera::SafeDownCast(caller);
    vtkRenderer* const renderer = filter ? filter->GetRenderer() : nullptr;
    auto* const camera =
      renderer ? vtkWideFoVCamera::SafeDownCast(renderer->GetActiveCamera()) : nullptr;
    vtkPointSet* const made = camera ? filter->GetOutput() : nullptr;
    vtkDataArray* const sizes =
      made ? made->GetPointData()->GetArray(filter->GetDistanceArrayName()) : nullptr;
    for (vtkIdType i = 0; sizes && i < sizes->GetNumberOfTuples(); i++)
    {
      const double* const place = made->GetPoint(i);
      const double flat = FlatPixelSize(renderer, camera, place);
      const double pixel = wfv::FindPixelSize(renderer, camera, place);
      if (flat > 0)
      {
        sizes->SetTuple1(i, sizes->GetTuple1(i) * pixel / flat);
      }
    }
  }
};

Sizer* GetSizer()
{
  static const vtkNew<Sizer> sizer; // keeps nothing, so that it serves all filters
  return sizer;
}

// Says once what a filter asks that no wide view can answer.
void Warn(vtkAlgorithm* filter)
{
  const char* const wrong = wfv::HasTrait(filter, wfv::SortsByCamera)
    ? " sorts along the direction of view, which is no order of a wide picture; what is "
      "translucent "
      "is right with UseDepthPeeling"
    : wfv::HasTrait(filter, wfv::CullsByCamera)
    ? " leaves out what a perspective would not show, or shows it coarser; take it out, or switch "
      "that off"
    : nullptr;
  const std::string name = filter->GetClassName();
  if (wrong && wfv::IsNews("filter " + name))
  {
    vtkWarningWithObjectMacro(filter, << name << wrong);
  }
}

// All that comes before, each once.
void AddUpstream(vtkAlgorithm* algorithm, std::vector<vtkAlgorithm*>& all)
{
  for (int port = 0; port < algorithm->GetNumberOfInputPorts(); port++)
  {
    for (int i = 0; i < algorithm->GetNumberOfInputConnections(port); i++)
    {
      vtkAlgorithm* const before = algorithm->GetInputAlgorithm(port, i);
      if (before && std::find(all.begin(), all.end(), before) == all.end())
      {
        all.push_back(before);
        AddUpstream(before, all);
      }
    }
  }
}
}

namespace wfv
{
bool CameraFilters::Watch(vtkMapper* mapper)
{
  std::vector<vtkAlgorithm*> all;
  AddUpstream(mapper, all);
  bool found = false;
  for (vtkAlgorithm* const each : all)
  {
    Warn(each);
    auto* const sizing = vtkDistanceToCamera::SafeDownCast(each);
    if (sizing && !sizing->HasObserver(vtkCommand::EndEvent, GetSizer()))
    {
      sizing->AddObserver(vtkCommand::EndEvent, GetSizer());
      sizing->Modified();
      this->Sizing.emplace_back(sizing);
      found = true;
    }
  }
  return found;
}

bool CameraFilters::Begin(vtkRenderer* renderer, vtkWideFoVCamera* camera)
{
  if (this->Sizing.empty())
  {
    return false;
  }
  std::array<double, 14> view{ { camera->GetHorizontalFieldOfView(),
    camera->GetVerticalFieldOfView(), camera->GetTilt(),
    static_cast<double>(renderer->GetSize()[0]), static_cast<double>(renderer->GetSize()[1]) } };
  camera->GetLensCoefficients(&view[5]);
  const Projection* const map = &camera->GetProjectionDefinition();
  if (view == this->View && map == this->Map)
  {
    return false;
  }
  this->View = view;
  this->Map = map;
  for (vtkDistanceToCamera* const each : this->Sizing)
  {
    if (each)
    {
      each->Modified();
    }
  }
  return true;
}
}
