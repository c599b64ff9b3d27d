// SPDX-License-Identifier: BSD-3-Clause
#include "Drawables/PropFacts.h"

#include "vtkActor.h"
#include "vtkMapper.h"
#include "vtkShaderProperty.h"

#include <cstring>

namespace wfv
{
bool IsStockActor(vtkActor* actor)
{
  vtkMapper* const mapper = actor->GetMapper();
  const char* const name = mapper ? mapper->GetClassName() : "";
  return std::strcmp(actor->GetClassName(), "vtkOpenGLActor") == 0 &&
    (std::strcmp(name, "vtkOpenGLPolyDataMapper") == 0 ||
      std::strcmp(name, "vtkWideFoVPolyDataMapper") == 0);
}

bool IsOwnMapper(vtkObjectBase* mapper)
{
  return mapper && mapper->IsA("vtkWideFoVPolyDataMapper");
}

bool HasOwnShaders(vtkActor* actor)
{
  vtkShaderProperty* const shaders = actor->GetShaderProperty();
  return shaders->HasVertexShaderCode() || shaders->HasGeometryShaderCode() ||
    shaders->GetNumberOfShaderReplacements() > 0;
}
}
