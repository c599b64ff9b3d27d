// SPDX-License-Identifier: BSD-3-Clause
#include "Drawables/StockTraits.h"

#include "Drawables/Kinds/DrawableKinds.h"

#include "vtkActor.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkLightingMapPass.h"
#include "vtkOpenGLHelper.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkOpenGLVertexBufferObjectGroup.h"
#include "vtkPlaneCollection.h"
#include "vtkProperty.h"
#include "vtkShaderProperty.h"

namespace wfv
{
namespace stock
{
namespace
{
// What a pass may know of a mapper only from inside.
class TextAccess : public vtkOpenGLPolyDataMapper
{
public:
  static bool HasBuffer(vtkOpenGLPolyDataMapper* mapper, const char* name)
  {
    return (mapper->*(&TextAccess::VBOs))->GetNumberOfComponents(name) > 0;
  }

  static bool HasNormals(vtkOpenGLPolyDataMapper* mapper)
  {
    return HasBuffer(mapper, "normalMC") || mapper->*(&TextAccess::HaveCellNormals);
  }

  // As VTK counts: without a light nothing is lit, but by PBR.
  static Lit LightOf(vtkOpenGLPolyDataMapper* mapper, bool physical)
  {
    const auto& all = mapper->*(&TextAccess::PrimitiveInfo);
    const auto found = all.find(mapper->*(&TextAccess::LastBoundBO));
    if (found == all.end() || (!physical && found->second.LastLightCount == 0))
    {
      return Lit::No;
    }
    const int complexity = static_cast<int>(found->second.LastLightComplexity);
    return complexity <= 0 ? Lit::No : complexity == 1 ? Lit::Headlight : Lit::Otherwise;
  }
};

// Code or replacements of the user's own, and pictures of normals, which have no light.
bool IsForeign(vtkActor* actor)
{
  vtkInformation* const info = actor->GetPropertyKeys();
  vtkShaderProperty* const code = actor->GetShaderProperty();
  return code->HasVertexShaderCode() || code->HasFragmentShaderCode() ||
    code->HasGeometryShaderCode() || code->GetNumberOfShaderReplacements() > 0 ||
    (info && info->Has(vtkLightingMapPass::RENDER_NORMALS()));
}
}

Traits Describe(vtkAbstractMapper* mapper, vtkProp* prop)
{
  auto* const polydata = vtkOpenGLPolyDataMapper::SafeDownCast(mapper);
  auto* const actor = vtkActor::SafeDownCast(prop);
  Traits traits;
  if (!polydata || !actor)
  {
    return traits;
  }
  traits.Known = !IsForeign(actor);
  traits.Physical = actor->GetProperty()->GetInterpolation() == VTK_PBR;
  traits.Light = TextAccess::LightOf(polydata, traits.Physical);
  traits.Normals = TextAccess::HasNormals(polydata);
  traits.Wireframe = actor->GetProperty()->GetRepresentation() == VTK_WIREFRAME;
  traits.Glyphs = HasTrait(mapper, Glyphs);
  vtkPlaneCollection* const planes = mapper->GetClippingPlanes();
  traits.Clips = planes && planes->GetNumberOfItems() > 0;
  traits.Impostors = HasTrait(mapper, Spheres) || HasTrait(mapper, Cylinders) ||
    (HasTrait(mapper, Splats) && TextAccess::HasBuffer(polydata, "radiusMC"));
  return traits;
}
}
}
