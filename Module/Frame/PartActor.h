// SPDX-License-Identifier: BSD-3-Clause
// Actors that another prop draws and keeps to itself, such as the lines of polar axes.
#ifndef WideFoVPartActor_h
#define WideFoVPartActor_h

#include "Drawables/Facing.h"
#include "vtkWideFoVAbi.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkObject;
class vtkRenderer;
VTK_ABI_NAMESPACE_END

namespace wfv
{
class Stages;

// While there is one, what draws itself in the renderer can find the stages of its wide frame.
class FrameInDrawing
{
public:
  // stages: nullptr for what is no part of the frame, though it is drawn meanwhile; up: where the
  // tops of its texts point
  FrameInDrawing(vtkRenderer* renderer, Stages* stages, LabelUp up = LabelUp::Picture);
  ~FrameInDrawing();
  FrameInDrawing(const FrameInDrawing&) = delete;
  FrameInDrawing& operator=(const FrameInDrawing&) = delete;

private:
  FrameInDrawing* Before;
  vtkRenderer* Renderer;
  Stages* Found;
  LabelUp Up;

  friend LabelUp FindLabelUp();
  friend Stages* FindFrame(vtkRenderer* renderer);
  friend bool IsFrameInDrawing();
};

// The stages of the wide frame that is drawn in the renderer just now, else nullptr.
Stages* FindFrame(vtkRenderer* renderer);

// Returns the direction of the tops of texts in the innermost frame.
LabelUp FindLabelUp();

// In any renderer.
bool IsFrameInDrawing();

// Nobody can ask such a prop for its actors. So the ones that VTK makes look for the frame
// themselves, and so do texts (PartText.h): a factory makes them, under the names of VTK's own
// classes (Overrides.h). Where VTK's followers draw by them, these face the eye upright.
vtkObject* MakePartActor();

// True of an actor that was made so.
bool FindsItsFrame(vtkObject* actor);
}

#endif
