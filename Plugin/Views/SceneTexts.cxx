// SPDX-License-Identifier: BSD-3-Clause
#include "SceneTexts.h"

#include "FrameThreads.h"
#include "vtkWideFoVCamera.h"

#include "vtkBillboardTextActor3D.h"
#include "vtkFlagpoleLabel.h"
#include "vtkMath.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"

#include "Projections/Projection.h"

#include <cmath>

namespace wfvplugin
{
namespace
{
// A label knows how far its flag reaches only where it has been drawn once, and it may be drawn
// once, while the clip spheres are fitted before.
class LabelAccess : public vtkFlagpoleLabel
{
public:
  static void MakeFlag(vtkFlagpoleLabel* label, vtkRenderer* renderer)
  {
    if (label->GetInput() && label->GetInput()[0])
    {
      label->*(&LabelAccess::RenderedRenderer) = renderer;
      label->GetBounds();
    }
  }
};

// By how much the picture is higher, in radians of its middle, than VTK takes it to be.
double FactorOf(vtkWideFoVCamera* camera)
{
  const bool round = camera->GetProjectionDefinition().Axis == wfv::Family::Azimuthal;
  const double angle =
    round ? camera->GetHorizontalFieldOfView() : camera->GetVerticalFieldOfView();
  return vtkMath::RadiansFromDegrees(angle) /
    (2 * std::tan(vtkMath::RadiansFromDegrees(0.5 * camera->GetViewAngle())));
}
}

void SceneTexts::BeginBounds(vtkRenderer* renderer)
{
  auto* const camera = vtkWideFoVCamera::SafeDownCast(renderer->GetActiveCamera());
  if (!camera || !camera->IsWide())
  {
    return;
  }
  const double factor = FactorOf(camera);
  vtkPropCollection* const props = renderer->GetViewProps();
  vtkCollectionSimpleIterator it;
  props->InitTraversal(it);
  while (vtkProp* const prop = props->GetNextProp(it))
  {
    auto* const label = vtkFlagpoleLabel::SafeDownCast(prop);
    auto* const billboard = vtkBillboardTextActor3D::SafeDownCast(prop);
    if (label && label->GetVisibility())
    {
      this->Before.emplace_back(label, label->GetFlagSize());
      label->SetFlagSize(factor * label->GetFlagSize());
      label->SetForceOpaque(!HasOneRank());
      LabelAccess::MakeFlag(label, renderer);
    }
    if (billboard)
    {
      billboard->SetForceOpaque(!HasOneRank());
    }
  }
}

void SceneTexts::EndBounds()
{
  for (const auto& [label, size] : this->Before)
  {
    label->SetFlagSize(size);
  }
  this->Before.clear();
}
}
