// SPDX-License-Identifier: BSD-3-Clause
// What options mean together: defaults that depend on each other, contradictions.
#ifndef WideFoVOptionCheck_h
#define WideFoVOptionCheck_h

#include "FieldsOfView.h"
#include "Options.h"

namespace widefov
{
// Sets the fields of view to so many degrees across and, of projections that are not round, to as
// much upwards as makes the pixels square in the middle, or as much as there is.
void SetField(Options& options, double across);

// Completes the options; they are those of DeclareScene. Throws a Failure with ExitUsage.
void CheckScene(Options& options, const FieldsOfView& fov);

// Of complete options: can this technique draw the view so? Sets what follows from the names
// of the technique and of the depth mapping. Throws a Failure with ExitUsage.
void CheckDrawn(Options& options);

// As CheckScene, and checks the outputs of widefov-render.
void CheckTogether(Options& options, const FieldsOfView& fov);
}

#endif
