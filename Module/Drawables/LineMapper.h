// SPDX-License-Identifier: BSD-3-Clause
// What the stage asks a mapper about the lines or points that it is about to draw.
#ifndef WideFoVLineMapper_h
#define WideFoVLineMapper_h

#include "vtkWideFoVAbi.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkActor;
class vtkDataObject;
class vtkOpenGLPolyDataMapper;
VTK_ABI_NAMESPACE_END

namespace wfv
{
// Pixels. Thinner than one there would be gaps, and the hardware's lines are not either.
float LineWidth(vtkOpenGLPolyDataMapper* mapper, vtkActor* actor);

// Pixels. Those that are drawn to pick points have a size of their own.
float PointSize(vtkOpenGLPolyDataMapper* mapper, vtkActor* actor);

// True where more work for each line costs little in all.
// True while the mapper draws what is selected.
bool DrawsSelection(vtkOpenGLPolyDataMapper* mapper);

bool HasFewLines(vtkOpenGLPolyDataMapper* mapper);

// True where the technique "auto" draws them as exact strips: few lines, so wide that their ends
// and joints show.
bool NeedsStrips(vtkOpenGLPolyDataMapper* mapper, vtkActor* actor);

// True where an actor shows lines so wide of these data.
bool HasWideLines(vtkActor* actor, vtkDataObject* data);
}

#endif
