// SPDX-License-Identifier: BSD-3-Clause
#include "Compat/CompositeMapper.h"

#include "vtkObjectBase.h"

#include <cstring>

namespace
{
bool IsNamed(vtkObjectBase* object, const char* name)
{
  return std::strcmp(object->GetClassName(), name) == 0;
}
}

namespace wfv
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 0)
bool ClassifiesBlocks(vtkObjectBase*)
{
  return false;
}

bool IsStockComposite(vtkObjectBase* mapper)
{
  return IsNamed(mapper, "vtkCompositePolyDataMapper");
}

bool DrawsBlocks(vtkObjectBase* mapper)
{
  return IsNamed(mapper, "vtkOpenGLBatchedPolyDataMapper");
}
#else
bool ClassifiesBlocks(vtkObjectBase* mapper)
{
  return IsNamed(mapper, "vtkWideFoVCompositeHelper");
}

bool IsStockComposite(vtkObjectBase* mapper)
{
  return IsNamed(mapper, "vtkCompositePolyDataMapper2");
}

bool DrawsBlocks(vtkObjectBase* mapper)
{
  return IsNamed(mapper, "vtkCompositeMapperHelper2") ||
    IsNamed(mapper, "vtkWideFoVCompositeHelper");
}
#endif
}
