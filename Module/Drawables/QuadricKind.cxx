// SPDX-License-Identifier: BSD-3-Clause
#include "Drawables/QuadricKind.h"

#include "Drawables/Kinds/DrawableKinds.h"

#include "vtkActor.h"
#include "vtkOpenGLHelper.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkOpenGLVertexBufferObjectGroup.h"

namespace
{
using QuadricPrimitive = wfv::ShaderBuilder::Primitive;

// What a pass may know of a mapper only from inside.
class QuadricAccess : public vtkOpenGLPolyDataMapper
{
public:
  static bool HasRadii(vtkOpenGLPolyDataMapper* mapper)
  {
    auto* buffers = mapper->*(&QuadricAccess::VBOs);
    return buffers->GetNumberOfComponents("radiusMC") > 0;
  }

  static QuadricPrimitive Fake(
    vtkOpenGLPolyDataMapper* mapper, vtkActor* actor, QuadricPrimitive kind)
  {
    vtkOpenGLHelper* buffer = mapper->*(&QuadricAccess::LastBoundBO);
    const bool tubes = buffer && (mapper->*(&QuadricAccess::DrawingTubes))(*buffer, actor);
    const bool spheres = buffer && (mapper->*(&QuadricAccess::DrawingSpheres))(*buffer, actor);
    // stock VTK asks for tubes even while it draws points to pick them
    if (spheres || (tubes && kind == QuadricPrimitive::Points))
    {
      return QuadricPrimitive::PointSpheres;
    }
    return tubes ? QuadricPrimitive::Tubes : kind;
  }
};
}

namespace wfv
{
namespace quadric
{
QuadricPrimitive KindOf(vtkOpenGLPolyDataMapper* mapper, vtkActor* actor, QuadricPrimitive kind)
{
  if (HasTrait(mapper, Splats))
  {
    // without a radius it draws points
    return QuadricAccess::HasRadii(mapper) ? QuadricPrimitive::Splats : QuadricPrimitive::Points;
  }
  return HasTrait(mapper, Spheres) ? QuadricPrimitive::Spheres
    : HasTrait(mapper, Cylinders)  ? QuadricPrimitive::Cylinders
                                   : QuadricAccess::Fake(mapper, actor, kind);
}
}
}
