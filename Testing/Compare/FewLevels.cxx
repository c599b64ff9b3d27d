// SPDX-License-Identifier: BSD-3-Clause
// Loaded before OpenGL: a driver whose tessellator cuts an edge in 32 at most. OpenGL 4 asks for 64
// of every driver, so no real one is at hand that has fewer. Programs that are linked to OpenGL
// find this glGetIntegerv first; since 9.4 VTK looks its functions up by name, and finds it too.
#include <GL/gl.h>
#include <GL/glext.h>

#include <algorithm>
#include <cstring>
#include <dlfcn.h>

namespace
{
using Lookup = void* (*)(void*, const char*);
using Function = void (*)();
using FindFunction = Function (*)(const char*);
using AskInteger = void (*)(GLenum, GLint*);

AskInteger Ask = nullptr;     // the driver's own
FindFunction Finders[2] = {}; // of EGL and GLX

template <class To, class From>
To Cast(From from)
{
  return reinterpret_cast<To>(from);
}

// dlsym() of the C library; every glibc that has it there, 2.34 and later, gives it this version.
Lookup RealLookup()
{
  static const auto real = Cast<Lookup>(dlvsym(RTLD_NEXT, "dlsym", "GLIBC_2.34"));
  return real;
}

void AskLess(GLenum name, GLint* values)
{
  Ask(name, values);
  if (name == GL_MAX_TESS_GEN_LEVEL)
  {
    values[0] = std::min(values[0], 32);
  }
}

// What is found, or what is to be in its place.
Function InPlaceOf(const char* name, Function found)
{
  if (!found || std::strcmp(name, "glGetIntegerv") != 0)
  {
    return found;
  }
  Ask = Cast<AskInteger>(found);
  return Cast<Function>(&AskLess);
}

template <int Kind>
Function Find(const char* name)
{
  return InPlaceOf(name, Finders[Kind](name));
}
}

extern "C" void glGetIntegerv(GLenum name, GLint* values)
{
  static const auto next = Cast<AskInteger>(RealLookup()(RTLD_NEXT, __func__));
  Ask = next;
  AskLess(name, values);
}

extern "C" void* dlsym(void* handle, const char* name)
{
  void* const found = RealLookup()(handle, name);
  if (found && std::strcmp(name, "eglGetProcAddress") == 0)
  {
    Finders[0] = Cast<FindFunction>(found);
    return Cast<void*>(&Find<0>);
  }
  if (found && std::strncmp(name, "glXGetProcAddress", 17) == 0)
  {
    Finders[1] = Cast<FindFunction>(found);
    return Cast<void*>(&Find<1>);
  }
  return Cast<void*>(InPlaceOf(name, Cast<Function>(found)));
}
