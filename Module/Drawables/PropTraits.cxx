// SPDX-License-Identifier: BSD-3-Clause
#include "Drawables/PropTraits.h"

#include "Drawables/Kinds/DrawableKinds.h"

#include "vtkActor.h"
#include "vtkShaderProperty.h"

namespace wfv
{
bool HasOwnShaders(vtkActor* actor)
{
  vtkShaderProperty* const shaders = actor->GetShaderProperty();
  return shaders->HasVertexShaderCode() || shaders->HasGeometryShaderCode() ||
    shaders->GetNumberOfShaderReplacements() > 0;
}
}
