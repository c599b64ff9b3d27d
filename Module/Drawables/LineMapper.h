// SPDX-License-Identifier: BSD-3-Clause
// Tells the stage about the lines or points that a mapper is about to draw.
#ifndef WideFoVLineMapper_h
#define WideFoVLineMapper_h

#include "vtkWideFoVAbi.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkActor;
class vtkOpenGLPolyDataMapper;
VTK_ABI_NAMESPACE_END

namespace wfv
{
// Pixels. Thinner than one there would be gaps, and the hardware's lines are not either.
float LineWidth(vtkOpenGLPolyDataMapper* mapper, vtkActor* actor);

// Pixels. Those that are drawn to pick points have a size of their own.
float PointSize(vtkOpenGLPolyDataMapper* mapper, vtkActor* actor);

// True while the mapper draws the selection.
bool DrawsSelection(vtkOpenGLPolyDataMapper* mapper);

// True if more work for each line costs little in all.
bool HasFewLines(vtkOpenGLPolyDataMapper* mapper);
}

#endif
