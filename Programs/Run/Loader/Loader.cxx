// SPDX-License-Identifier: BSD-3-Clause
// What a VTK finds on VTK_AUTOLOAD_PATH. It links with no VTK: one that is not that of the module
// is told apart before a second one is in the process.
#include <vtkVersionMacros.h>

#include <cstdlib>
#include <cstring>
#include <dlfcn.h>
#include <link.h>
#include <string>
#include <unistd.h>

namespace
{
constexpr int ExitFailed = 1;

// The process goes, for what was asked of it cannot be: nobody is to take a flat picture for a wide
// one. Nothing of it has begun yet, or what has knows nothing of this library.
[[noreturn]] void Refuse(const std::string& why)
{
  const std::string line = "widefov-run: " + why + "\n";
  if (write(STDERR_FILENO, line.data(), line.size()) < 0)
  {
    _exit(ExitFailed + 1);
  }
  _exit(ExitFailed);
}

std::string RealPath(const char* path)
{
  char* const real = realpath(path, nullptr);
  const std::string result = real ? real : path;
  free(real);
  return result;
}

// The file that a library of that name was loaded from; empty where none was.
std::string LoadedFile(const char* name)
{
  void* const library = dlopen(name, RTLD_LAZY | RTLD_NOLOAD);
  link_map* map = nullptr;
  if (!library || dlinfo(library, RTLD_DI_LINKMAP, &map) != 0)
  {
    return {};
  }
  const std::string file = RealPath(map->l_name);
  dlclose(library);
  return file;
}

// What the VTK in that file says of itself, by a function of C.
std::string VersionOf(const std::string& file)
{
  void* const library = dlopen(file.c_str(), RTLD_LAZY | RTLD_NOLOAD);
  using Function = const char* (*)();
  // of a program with VTK in itself there is no library
  const auto version =
    reinterpret_cast<Function>(dlsym(library ? library : RTLD_DEFAULT, "GetVTKVersion"));
  return version ? version() : "of another kind";
}

void CheckCaller(void* address)
{
  Dl_info caller;
  if (dladdr(address, &caller) == 0 || !caller.dli_fname)
  {
    Refuse("it cannot be told which VTK this program has");
  }
  const std::string file = RealPath(caller.dli_fname);
  const std::string version = VersionOf(file);
  const bool fits = file == LoadedFile(WIDEFOV_VTK_LIBRARY) && version == VTK_VERSION;
  if (!fits)
  {
    Refuse("this program has a VTK " + version + " (" + file + "), and WideFoV was built for " +
      VTK_VERSION + " (" + WIDEFOV_VTK_LIBRARY + "); run it with a WideFoV for its own");
  }
}

std::string OwnFolder()
{
  Dl_info own;
  dladdr(reinterpret_cast<void*>(&OwnFolder), &own);
  const std::string file = RealPath(own.dli_fname);
  return file.substr(0, file.rfind('/'));
}
}

// The names and types that VTK looks for; a factory is an address here.
#define WIDEFOV_EXPORT extern "C" __attribute__((visibility("default")))

WIDEFOV_EXPORT const char* vtkGetFactoryVersion()
{
  CheckCaller(__builtin_return_address(0));
  return VTK_SOURCE_VERSION;
}

WIDEFOV_EXPORT void* vtkLoad()
{
  CheckCaller(__builtin_return_address(0));
  const std::string file = OwnFolder() + "/" + WIDEFOV_OVERRIDES;
  void* const library = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL); // and stays
  using Function = void* (*)();
  const auto make =
    library ? reinterpret_cast<Function>(dlsym(library, "widefovMakeFactory")) : nullptr;
  if (!make)
  {
    Refuse(std::string("cannot load WideFoV: ") + dlerror());
  }
  return make();
}
