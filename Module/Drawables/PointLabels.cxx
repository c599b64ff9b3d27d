// SPDX-License-Identifier: BSD-3-Clause
#include "Drawables/PointLabels.h"

#include "Compat/Reports.h"
#include "vtkWideFoVCamera.h"

#include "vtkActor2D.h"
#include "vtkCoordinate.h"
#include "vtkDataSet.h"
#include "vtkDynamic2DLabelMapper.h"
#include "vtkFreeTypeLabelRenderStrategy.h"
#include "vtkLabelPlacementMapper.h"
#include "vtkLabeledDataMapper.h"
#include "vtkNew.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkTextMapper.h"
#include "vtkTextProperty.h"
#include "vtkTransform.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace
{
// Without a setter that says that the mapper was modified.
class PlacementAccess : public vtkLabelPlacementMapper
{
public:
  static vtkLabelRenderStrategy*& Strategy(vtkLabelPlacementMapper* mapper)
  {
    return mapper->*(&PlacementAccess::RenderStrategy);
  }
};

class LabeledAccess : public vtkLabeledDataMapper
{
public:
  static vtkTextMapper* Text(vtkLabeledDataMapper* mapper, int i)
  {
    return (mapper->*(&LabeledAccess::TextMappers))[i];
  }

  static int Count(vtkLabeledDataMapper* mapper)
  {
    return mapper->*(&LabeledAccess::NumberOfLabels);
  }

  static const double* Place(vtkLabeledDataMapper* mapper, int i)
  {
    const double* const place = mapper->*(&LabeledAccess::LabelPositions) + 3 * i;
    vtkTransform* const transform = mapper->*(&LabeledAccess::Transform);
    return transform ? transform->TransformDoublePoint(place) : place;
  }
};

// Asked for the size of each label before it is placed, with a text property of this label alone.
class TurningStrategy : public vtkFreeTypeLabelRenderStrategy
{
public:
  static TurningStrategy* New()
  {
    auto* const made = new TurningStrategy;
    made->InitializeObjectBase();
    return made;
  }

  void ComputeLabelBounds(vtkTextProperty* text, vtkStdString label, double bounds[4]) override
  {
    if (this->Anchor->GetCoordinateSystem() == VTK_WORLD)
    {
      const double turn =
        wfv::FindLabelTurn(this->Renderer, this->Camera, this->Up, this->Anchor->GetValue());
      text->SetOrientation(text->GetOrientation() + turn);
    }
    this->vtkFreeTypeLabelRenderStrategy::ComputeLabelBounds(text, std::move(label), bounds);
  }

  vtkCoordinate* Anchor = nullptr; // of the label that is placed
  vtkWideFoVCamera* Camera = nullptr;
  wfv::LabelUp Up = wfv::LabelUp::Picture;
};

void DrawPlaced(vtkActor2D* labels, vtkLabelPlacementMapper* mapper, vtkRenderer* renderer,
  vtkWideFoVCamera* camera, wfv::LabelUp up)
{
  vtkLabelRenderStrategy*& strategy = PlacementAccess::Strategy(mapper);
  vtkLabelRenderStrategy* const before = strategy;
  const std::string name = before ? before->GetClassName() : "";
  if (name != "vtkFreeTypeLabelRenderStrategy")
  {
    if (wfv::IsNews("labels by " + name))
    {
      vtkWarningWithObjectMacro(mapper, << "labels by " << name << " stand upright in the picture");
    }
    wfv::DrawOverlay(labels, renderer);
    return;
  }
  vtkNew<TurningStrategy> turning;
  turning->Anchor = mapper->GetAnchorTransform();
  turning->Camera = camera;
  turning->Up = up;
  strategy = turning;
  wfv::DrawOverlay(labels, renderer);
  strategy = before;
  turning->ReleaseGraphicsResources(renderer->GetVTKWindow());
}

// Finds the world position of a label. Returns false if the label has a position in the picture.
bool FindPlace(vtkLabeledDataMapper* mapper, int i, double place[3])
{
  if (vtkDynamic2DLabelMapper::SafeDownCast(mapper))
  {
    auto* const data = vtkDataSet::SafeDownCast(mapper->GetInputDataObject(0, 0));
    const bool has = data && i < data->GetNumberOfPoints();
    if (has)
    {
      data->GetPoint(i, place);
      place[2] = 0; // VTK puts them there
    }
    return has;
  }
  std::copy_n(LabeledAccess::Place(mapper, i), 3, place);
  return mapper->GetCoordinateSystem() == vtkLabeledDataMapper::WORLD;
}

void DrawLabeled(vtkActor2D* labels, vtkLabeledDataMapper* mapper, vtkRenderer* renderer,
  vtkWideFoVCamera* camera, wfv::LabelUp up)
{
  labels->RenderOpaqueGeometry(renderer); // makes the labels
  std::vector<std::pair<vtkTextMapper*, vtkSmartPointer<vtkTextProperty>>> before;
  for (int i = 0; i < LabeledAccess::Count(mapper); i++)
  {
    double place[3];
    const double turn =
      FindPlace(mapper, i, place) ? wfv::FindLabelTurn(renderer, camera, up, place) : 0;
    vtkTextMapper* const text = LabeledAccess::Text(mapper, i);
    if (turn != 0 && text->GetTextProperty())
    {
      before.emplace_back(text, text->GetTextProperty());
      vtkNew<vtkTextProperty> turned;
      turned->ShallowCopy(text->GetTextProperty());
      turned->SetOrientation(turned->GetOrientation() + turn);
      text->SetTextProperty(turned);
    }
  }
  labels->RenderOverlay(renderer);
  for (const auto& each : before)
  {
    each.first->SetTextProperty(each.second);
  }
}
}

namespace wfv
{
void DrawOverlay(vtkActor2D* overlay, vtkRenderer* renderer)
{
  overlay->RenderOpaqueGeometry(renderer);
  if (overlay->HasTranslucentPolygonalGeometry())
  {
    overlay->RenderTranslucentPolygonalGeometry(renderer);
  }
  overlay->RenderOverlay(renderer);
}

void DrawPointLabels(
  vtkActor2D* labels, vtkRenderer* renderer, vtkWideFoVCamera* camera, LabelUp up)
{
  if (auto* const placed = vtkLabelPlacementMapper::SafeDownCast(labels->GetMapper()))
  {
    DrawPlaced(labels, placed, renderer, camera, up);
  }
  else if (auto* const labeled = vtkLabeledDataMapper::SafeDownCast(labels->GetMapper()))
  {
    DrawLabeled(labels, labeled, renderer, camera, up);
  }
  else
  {
    DrawOverlay(labels, renderer);
  }
}
}
