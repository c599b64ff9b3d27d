// SPDX-License-Identifier: BSD-3-Clause
// ParaView's axes grid, and what of it has no getter. Up to ParaView 5.13 it is a class of
// ParaView's; VTK has had it since 9.5, on which ParaView 6.0 is built, by another name.
#ifndef WideFoVPluginGridAxesActor_h
#define WideFoVPluginGridAxesActor_h

#include "vtkVersionMacros.h"

#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 5, 0)
#include "vtkGridAxesActor3D.h"
#else
#include "vtkGridAxes3DActor.h"
#endif

#include <string>

class vtkAxis;
class vtkDoubleArray;

namespace wfvplugin
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 5, 0)
using GridAxesActor = ::vtkGridAxesActor3D;
#else
using GridAxesActor = ::vtkGridAxes3DActor;
#endif

// The places of the numbers along an axis where a person chose them, or nullptr.
vtkDoubleArray* GetCustomLabels(GridAxesActor* actor, int axis);

// The text of the axis's tick, and where the data have been scaled for the display, that of its
// number before (since ParaView 5.12).
std::string GetTickText(GridAxesActor* actor, int axis, vtkAxis* numbers, vtkIdType tick);
}

#endif
