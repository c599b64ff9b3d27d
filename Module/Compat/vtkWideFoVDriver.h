// SPDX-License-Identifier: BSD-3-Clause
// What the OpenGL that is current is, and can.
#ifndef vtkWideFoVDriver_h
#define vtkWideFoVDriver_h

namespace wfv
{
bool HasExtension(const char* name);

// Mesa's software renderers.
bool IsSoftwareMesa();
}

#endif
