// SPDX-License-Identifier: BSD-3-Clause
// What vtkWideFoVPass keeps from frame to frame.
#ifndef vtkWideFoVPassInternals_h
#define vtkWideFoVPassInternals_h

#include "Drawables/Billboards.h"
#include "Drawables/FlatHabits.h"
#include "Frame/Backdrop.h"
#include "Frame/FrameProps.h"
#include "Frame/FrameRate.h"
#include "Frame/GpuVolumes.h"
#include "Frame/Headlights.h"
#include "Frame/PropKeys.h"
#include "Frame/PropParts.h"
#include "Frame/SmallFrame.h"
#include "Frame/Stages.h"
#include "vtkWideFoVPass.h"

#include "vtkActor2D.h"
#include "vtkNew.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"

#include <vector>

struct vtkWideFoVPass::Internals
{
  vtkSmartPointer<vtkRenderPass> Delegate;
  wfv::Stages Stages;
  vtkNew<vtkWideFoVHeadlights> Headlights; // of flat screens
  wfv::FrameProps Props;                   // as they came
  wfv::Billboards Texts;                   // that stand in the scene
  std::vector<vtkWideFoVStage*> Chosen;    // one a prop that is seen, kept for its memory
  std::vector<wfv::PropKeys> Keys;         // the same, as many as there ever were
  wfv::PropParts Parts;                    // of those that are made of several
  wfv::FlatHabits Habits;                  // of those that are drawn
  wfv::FrameRate Rate;
  wfv::SmallFrame Small;
  wfv::Backdrop Backdrop;
  wfv::GpuVolumes GpuVolumes;         // of the processor's
  vtkWideFoVCamera* Camera = nullptr; // of this frame
  bool OfCopy = false;                // the renderer's camera was a copy of it
  int Enlargement = 0;                // of this frame; 0: drawn where it is shown
  std::vector<vtkActor2D*> Flat;      // of a frame that is enlarged: drawn upon it
  std::vector<vtkActor2D*> Labels;    // that leave out what is behind a flat picture
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
};
}

#endif
