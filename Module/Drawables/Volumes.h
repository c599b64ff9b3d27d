// SPDX-License-Identifier: BSD-3-Clause
// Volumes: which can be drawn in a wide view, what is known of their text, and what their programs
// are told.
#ifndef WideFoVVolumes_h
#define WideFoVVolumes_h

#include "Projections/Bounds/Visibility.h"
#include "Shaders/volumes/VolumeShaders.h"
#include "vtkWideFoVAbi.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkAbstractVolumeMapper;
class vtkProp;
class vtkRenderer;
class vtkShaderProgram;
class vtkVolume;
VTK_ABI_NAMESPACE_END

namespace wfv
{
namespace volume
{
// Whether the mapper draws by GPU ray casting, as long as it is not told otherwise.
bool IsByGpu(vtkAbstractVolumeMapper* mapper);

// True of a volume whose mapper makes the rays of a flat picture itself, on the processor or of
// tetrahedra, or whose image has no thickness. Warns once of each kind.
bool IsFlatVolume(vtkProp* prop);

// Of the text that VTK's GPU ray casting writes for the volume.
Traits Describe(vtkRenderer* renderer, vtkVolume* volume);

// The uniforms of volume_geometry.glsl: rectangles that hold these pictures, none of which meets
// another; pixels: of the whole picture.
void SetCover(vtkShaderProgram* program, const Pictures& pictures, const vec2& pixels);
}
}

#endif
