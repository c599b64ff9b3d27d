// SPDX-License-Identifier: BSD-3-Clause
// Views as a lens was calibrated, and round maps anywhere in the picture.
#ifndef WideFoVLensView_h
#define WideFoVLensView_h

#include "FieldsOfView.h"
#include "Options.h"

namespace widefov
{
// Reads --lens-file, where one is given: the projection, the lens, its place, and the size of the
// picture unless there is one. Returns the fields of view, that of the lens among them. Throws a
// Failure.
FieldsOfView TakeLensFile(Options& options, const FieldsOfView& fov);

// What --circle means, of options that are complete but for it. Throws a Failure.
void TakeCircle(Options& options, const wfv::Projection& projection);
}

#endif
