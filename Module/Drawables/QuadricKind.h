// SPDX-License-Identifier: BSD-3-Clause
// Which of a mapper's draws are spheres, cylinders, tubes or splats: what the stock mapper would
// fake in the plane of the picture.
#ifndef WideFoVQuadricKind_h
#define WideFoVQuadricKind_h

#include "Shaders/ShaderBuilder.h"
#include "vtkWideFoVAbi.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkActor;
class vtkOpenGLPolyDataMapper;
VTK_ABI_NAMESPACE_END

namespace wfv
{
namespace quadric
{
// The kind of the draw that the mapper is preparing, or the one given.
wfv::ShaderBuilder::Primitive KindOf(
  vtkOpenGLPolyDataMapper* mapper, vtkActor* actor, wfv::ShaderBuilder::Primitive kind);
}
}

#endif
