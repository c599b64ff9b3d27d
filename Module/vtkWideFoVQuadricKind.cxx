// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWideFoVQuadricKind.h"

#include "vtkActor.h"
#include "vtkOpenGLHelper.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkOpenGLVertexBufferObjectGroup.h"

namespace
{
using Primitive = vtkWideFoVShaderBuilder::Primitive;

// What a pass may know of a mapper only from inside.
class MapperAccess : public vtkOpenGLPolyDataMapper
{
public:
  static bool HasRadii(vtkOpenGLPolyDataMapper* mapper)
  {
    auto* buffers = mapper->*(&MapperAccess::VBOs);
    return buffers->GetNumberOfComponents("radiusMC") > 0;
  }

  static Primitive Fake(vtkOpenGLPolyDataMapper* mapper, vtkActor* actor, Primitive kind)
  {
    vtkOpenGLHelper* buffer = mapper->*(&MapperAccess::LastBoundBO);
    const bool tubes = buffer && (mapper->*(&MapperAccess::DrawingTubes))(*buffer, actor);
    const bool spheres = buffer && (mapper->*(&MapperAccess::DrawingSpheres))(*buffer, actor);
    // stock VTK asks for tubes even while it draws points to pick them
    if (spheres || (tubes && kind == Primitive::Points))
    {
      return Primitive::PointSpheres;
    }
    return tubes ? Primitive::Tubes : kind;
  }
};
}

namespace wfv
{
namespace quadric
{
Primitive KindOf(vtkOpenGLPolyDataMapper* mapper, vtkActor* actor, Primitive kind)
{
  if (mapper->IsA("vtkOpenGLPointGaussianMapperHelper"))
  {
    // without a radius it draws plain points
    return MapperAccess::HasRadii(mapper) ? Primitive::Splats : Primitive::Points;
  }
  if (mapper->IsA("vtkOpenGLSphereMapper") || mapper->IsA("vtkOpenGLStickMapper"))
  {
    return mapper->IsA("vtkOpenGLSphereMapper") ? Primitive::Spheres : Primitive::Sticks;
  }
  return MapperAccess::Fake(mapper, actor, kind);
}
}
}
