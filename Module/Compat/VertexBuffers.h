// SPDX-License-Identifier: BSD-3-Clause
// The vertex buffers of a mapper by the names of their attributes, which VTK keeps to itself.
#ifndef WideFoVVertexBuffers_h
#define WideFoVVertexBuffers_h

#include "vtkOpenGLVertexBufferObject.h"
#include "vtkOpenGLVertexBufferObjectGroup.h"

#include <map>
#include <string>

namespace wfv
{
class VertexBufferAccess : public vtkOpenGLVertexBufferObjectGroup
{
public:
  using Buffers = std::map<std::string, vtkOpenGLVertexBufferObject*>;
  static const Buffers& Of(vtkOpenGLVertexBufferObjectGroup* group)
  {
    return group->*(&VertexBufferAccess::UsedVBOs);
  }
};
}

#endif
