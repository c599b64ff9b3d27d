// SPDX-License-Identifier: BSD-3-Clause
#include "Frame/PartText.h"

#include "Drawables/Billboards.h"
#include "Frame/PartActor.h"
#include "Frame/PropKeys.h"
#include "Frame/Stages.h"
#include "vtkWideFoVCamera.h"

#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkOpenGLBillboardTextActor3D.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"

namespace wfv
{
namespace
{
// Without a name of its own: whoever asks sees the class that it stands for.
class PartText : public vtkOpenGLBillboardTextActor3D
{
public:
  static PartText* New()
  {
    auto* const made = new PartText;
    made->InitializeObjectBase();
    return made;
  }

  // Its rectangle is made for one camera: no part that a wide frame could draw.
  void GetActors(vtkPropCollection* props) override
  {
    if (!IsFrameInDrawing())
    {
      this->vtkOpenGLBillboardTextActor3D::GetActors(props);
    }
  }

  int RenderOpaqueGeometry(vtkViewport* viewport) override
  {
    return this->Show(viewport,
      [&] { return this->vtkOpenGLBillboardTextActor3D::RenderOpaqueGeometry(viewport); });
  }

  int RenderTranslucentPolygonalGeometry(vtkViewport* viewport) override
  {
    return this->Show(viewport, [&] {
      return this->vtkOpenGLBillboardTextActor3D::RenderTranslucentPolygonalGeometry(viewport);
    });
  }

protected:
  vtkObjectBase* NewInstanceInternal() const override { return PartText::New(); }

private:
  template <typename F>
  int Show(vtkViewport* viewport, const F& draw)
  {
    auto* const renderer = vtkRenderer::SafeDownCast(viewport);
    Stages* const stages = renderer ? FindFrame(renderer) : nullptr;
    auto* const camera =
      stages ? vtkWideFoVCamera::SafeDownCast(renderer->GetActiveCamera()) : nullptr;
    if (!camera)
    {
      return draw();
    }
    int drawn = 0;
    const LabelUp up = FindLabelUp();
    const FrameInDrawing none(renderer, nullptr);
    ShowBillboard(this, renderer, camera, stages->Projected->GetTile(), up, [&] {
      // the whole's keys, which it has been given, have the whole's stage
      const vtkSmartPointer<vtkInformation> before = this->PropertyKeys;
      this->Keys->Copy(before);
      HandPassesOn(before, this->Keys);
      this->PropertyKeys = this->Keys;
      drawn = draw();
      this->PropertyKeys = before;
    });
    return drawn;
  }

  vtkNew<vtkInformation> Keys;
};
}

vtkObject* MakePartText()
{
  return PartText::New();
}
}
