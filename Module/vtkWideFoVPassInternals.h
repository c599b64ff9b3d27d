// SPDX-License-Identifier: BSD-3-Clause
// What vtkWideFoVPass keeps from frame to frame.
#ifndef vtkWideFoVPassInternals_h
#define vtkWideFoVPassInternals_h

#include "vtkWideFoVBillboards.h"
#include "vtkWideFoVEyesAtOnce.h"
#include "vtkWideFoVFrameProps.h"
#include "vtkWideFoVHeadlights.h"
#include "vtkWideFoVPass.h"
#include "vtkWideFoVPropKeys.h"
#include "vtkWideFoVStages.h"

#include "vtkNew.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"

#include <vector>

struct vtkWideFoVPass::Internals
{
  vtkSmartPointer<vtkRenderPass> Delegate;
  vtkWideFoVStages Stages;
  vtkNew<vtkWideFoVHeadlights> Headlights; // of flat screens
  wfv::FrameProps Props;                   // as they came
  wfv::Billboards Texts;                   // that stand in the scene
  std::vector<vtkWideFoVStage*> Chosen;    // one a prop that is seen, kept for its memory
  std::vector<wfv::PropKeys> Keys;         // the same, as many as there ever were

  // Of this frame.
  wfv::EyesAtOnce Eyes;
  wfv::EyesAtOnce::Frame Frame;
  wfv::EyesAtOnce::Role Role = wfv::EyesAtOnce::Alone;
  int Shared = 0; // of the props that are seen, the first may be drawn for both eyes at once

  // Props and their stages, while they are put in another order.
  std::vector<vtkProp*> Others;
  std::vector<vtkWideFoVStage*> OtherStages;
};

namespace wfv
{
// The renderer's own list is what its stock passes go through.
class RendererAccess : public vtkRenderer
{
public:
  static bool Has(vtkRenderer* renderer, vtkProp** props)
  {
    return renderer->*(&RendererAccess::PropArray) == props;
  }

  static void SetCount(vtkRenderer* renderer, vtkProp** props, int count)
  {
    if (Has(renderer, props))
    {
      renderer->*(&RendererAccess::PropArrayCount) = count;
    }
  }

  // So many further on in the list, or back.
  static void Skip(vtkRenderer* renderer, int count)
  {
    renderer->*(&RendererAccess::PropArray) += count;
    renderer->*(&RendererAccess::PropArrayCount) -= count;
  }
};
}

#endif
