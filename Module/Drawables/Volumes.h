// SPDX-License-Identifier: BSD-3-Clause
// What a program that draws a volume is told, and what is known of its text.
#ifndef WideFoVVolumes_h
#define WideFoVVolumes_h

#include "Projections/Bounds/Visibility.h"
#include "Shaders/volumes/VolumeShaders.h"
#include "vtkWideFoVAbi.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkRenderer;
class vtkShaderProgram;
class vtkVolume;
VTK_ABI_NAMESPACE_END

namespace wfv
{
namespace volume
{
// Of the text that VTK's GPU ray casting writes for the volume.
Facts Describe(vtkRenderer* renderer, vtkVolume* volume);

// The uniforms of volume_geometry.glsl: rectangles that hold these pictures, none of which meets
// another; pixels: of the whole picture.
void SetCover(vtkShaderProgram* program, const Pictures& pictures, const vec2& pixels);
}
}

#endif
