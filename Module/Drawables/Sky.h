// SPDX-License-Identifier: BSD-3-Clause
// VTK's skybox. The actor in the scene draws nothing itself: another one, which it keeps to itself,
// has the shaders.
#ifndef WideFoVSky_h
#define WideFoVSky_h

#include "Shaders/sky/SkyShaders.h"
#include "vtkWideFoVAbi.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkActor;
class vtkProp;
class vtkShaderProgram;
class vtkWindow;
VTK_ABI_NAMESPACE_END

namespace wfv
{
namespace sky
{
bool Is(vtkProp* prop);

// True of a sky that cannot be drawn: without a texture, which is warned of once, or while props
// are picked, which no sky can be.
bool IsLeftOut(vtkProp* prop, bool selects);

// What draws a sky, with the kind among its keys; nullptr of anything else.
vtkActor* PrepareDrawer(vtkProp* prop);

// Of what draws a sky.
Kind KindOf(vtkProp* drawer);

// The uniforms of sky_fragment.glsl. worldToView: row-major.
void SetWorld(vtkShaderProgram* program, const double worldToView[16]);
void SetTexture(vtkShaderProgram* program, vtkProp* drawer, vtkWindow* window);
}
}

#endif
