/* SPDX-License-Identifier: BSD-3-Clause
   What a program with another VTK does with a library that it finds on VTK_AUTOLOAD_PATH. */
#include <dlfcn.h>
#include <stdio.h>

__attribute__((visibility("default"))) const char* GetVTKVersion(void)
{
  return "8.9.7";
}

int main(int argc, char** argv)
{
  void* const library = argc > 1 ? dlopen(argv[1], RTLD_LAZY) : NULL;
  const char* (*const version)(void) =
    library ? (const char* (*)(void))dlsym(library, "vtkGetFactoryVersion") : NULL;
  if (!version)
  {
    printf("there is no factory\n");
    return 3;
  }
  printf("its version is %s\n", version());
  return 0;
}
