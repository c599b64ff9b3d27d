// SPDX-License-Identifier: BSD-3-Clause
// What VTK writes into the shaders of a mapper, by what the mapper says of itself: what an edit
// must find is not decided by the text in which it looks.
#ifndef WideFoVStockTraits_h
#define WideFoVStockTraits_h

#include "Compat/StockEdits.h"
#include "vtkWideFoVAbi.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkAbstractMapper;
class vtkProp;
VTK_ABI_NAMESPACE_END

namespace wfv
{
namespace stock
{
Traits Describe(vtkAbstractMapper* mapper, vtkProp* prop);
}
}

#endif
