// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWideFoVCompositeMapper.h"

#if VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 3, 0)
#include "vtkWideFoVCompositeHelper.h"
#endif

#include "vtkMapper.h"

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
void ClassifyBlocksOf(vtkMapper*, vtkWindow*) {}

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
void ClassifyBlocksOf(vtkMapper* mapper, vtkWindow* window)
{
  vtkWideFoVCompositeHelper::GiveTo(mapper, window);
}

bool ClassifiesBlocks(vtkObjectBase* mapper)
{
  return vtkWideFoVCompositeHelper::SafeDownCast(mapper) != nullptr;
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
