// SPDX-License-Identifier: BSD-3-Clause
// VTK shifts and scales the points of a scene of more than 31 units on their way into the
// vertex buffer, which rounds them once more. Points that are float32 already, round the
// origin, gain nothing by that: their mappers are told to leave them as they are.
#ifndef WideFoVBufferScale_h
#define WideFoVBufferScale_h

#include "vtkWideFoVAbi.h"

#include "vtkWeakPointer.h"

#include <unordered_map>

VTK_ABI_NAMESPACE_BEGIN
class vtkMapper;
class vtkProp;
VTK_ABI_NAMESPACE_END

namespace wfv
{
class BufferScale
{
public:
  // Before the prop is drawn, its input being up to date. A mapper keeps the method that its user
  // has chosen; one that is changed here is changed back when its points are others.
  void Prepare(vtkProp* prop);

private:
  std::unordered_map<vtkMapper*, vtkWeakPointer<vtkMapper>> Changed;
};
}

#endif
