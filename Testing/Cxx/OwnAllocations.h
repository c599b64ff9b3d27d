// SPDX-License-Identifier: BSD-3-Clause
// How often the module itself asks for memory.
#ifndef OwnAllocations_h
#define OwnAllocations_h

// Counts, while it lives, the calls of operator new that come from the module's library: directly,
// through the standard library or through VTK's containers (vtkCommonCore). What VTK's renderer and
// mappers, or OpenGL, allocate for themselves does not count. One at a time.
class OwnAllocations
{
public:
  OwnAllocations();
  ~OwnAllocations();
  OwnAllocations(const OwnAllocations&) = delete;
  OwnAllocations& operator=(const OwnAllocations&) = delete;

  // So far; the first few stacks are printed.
  int Count() const;
};

#endif
