// SPDX-License-Identifier: BSD-3-Clause
// Functions that VTK means to make const one day, and newer ones may be told to: with this after
// its declaration an override fits every VTK.
#ifndef WideFoVFutureConst_h
#define WideFoVFutureConst_h

#include "vtkObject.h"

#ifndef VTK_FUTURE_CONST
#define VTK_FUTURE_CONST
#endif

#endif
