// SPDX-License-Identifier: BSD-3-Clause
#include "Compat/Driver.h"

#include "Compat/Gl.h"

#include <cstring>

namespace
{
bool IsSoftwareMesa()
{
  const auto* renderer = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  return renderer && (std::strstr(renderer, "llvmpipe") || std::strstr(renderer, "softpipe"));
}
}

namespace wfv
{
bool HasExtension(const char* name)
{
  GLint count = 0;
  glGetIntegerv(GL_NUM_EXTENSIONS, &count);
  for (GLint i = 0; i < count; i++)
  {
    const auto* extension =
      reinterpret_cast<const char*>(glGetStringi(GL_EXTENSIONS, static_cast<GLuint>(i)));
    if (extension && std::strcmp(extension, name) == 0)
    {
      return true;
    }
  }
  return false;
}

bool NeedsSmallPatchDraws()
{
  return IsSoftwareMesa();
}
}
