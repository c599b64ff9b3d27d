// SPDX-License-Identifier: BSD-3-Clause
// The program's operator new, which serves all its libraries.
#include "OwnAllocations.h"

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <new>

#include <dlfcn.h>
#include <execinfo.h>
#include <unistd.h>

namespace
{
constexpr int MostFrames = 24;
constexpr int FramesPrinted = 12;
constexpr int StacksPrinted = 5;

thread_local bool counting = false;
thread_local bool inside = false; // what the count itself allocates
int counted = 0;

bool Holds(const char* file, const char* part)
{
  return file != nullptr && std::strstr(file, part) != nullptr;
}

// Templates of the standard library may be any library's copy.
bool Begins(const char* name, const char* start)
{
  return name != nullptr && std::strncmp(name, start, std::strlen(start)) == 0;
}

// The first that is neither a container's nor this program's own operator new.
bool IsOwn(void* const* frames, int n)
{
  for (int i = 2; i < n; i++)
  {
    Dl_info info;
    if (dladdr(frames[i], &info) == 0)
    {
      return false;
    }
    const char* const name = info.dli_sname;
    const bool standard = Begins(name, "_ZNSt") || Begins(name, "_ZNKSt") || Begins(name, "_ZSt");
    const bool container =
      standard || Holds(info.dli_fname, "libstdc++") || Holds(info.dli_fname, "vtkCommonCore");
    if (!container)
    {
      return Holds(info.dli_fname, "vtkRenderingWideFoV");
    }
  }
  return false;
}

// Never inlined: IsOwn counts two frames of its own.
[[gnu::noinline]] void Note()
{
  inside = true;
  void* frames[MostFrames];
  const int n = backtrace(frames, MostFrames);
  if (IsOwn(frames, n) && counted++ < StacksPrinted)
  {
    std::fprintf(stderr, "allocation %d:\n", counted);
    backtrace_symbols_fd(frames, n < FramesPrinted ? n : FramesPrinted, STDERR_FILENO);
  }
  inside = false;
}

void* Allocate(std::size_t size)
{
  if (counting && !inside)
  {
    Note();
  }
  void* const memory = std::malloc(size > 0 ? size : 1);
  if (memory == nullptr)
  {
    throw std::bad_alloc();
  }
  return memory;
}
}

void* operator new(std::size_t size)
{
  return Allocate(size);
}

void* operator new[](std::size_t size)
{
  return Allocate(size);
}

void operator delete(void* memory) noexcept
{
  std::free(memory);
}

void operator delete[](void* memory) noexcept
{
  std::free(memory);
}

void operator delete(void* memory, std::size_t) noexcept
{
  std::free(memory);
}

void operator delete[](void* memory, std::size_t) noexcept
{
  std::free(memory);
}

OwnAllocations::OwnAllocations()
{
  counted = 0;
  counting = true;
}

OwnAllocations::~OwnAllocations()
{
  counting = false;
}

int OwnAllocations::Count() const
{
  return counted;
}
