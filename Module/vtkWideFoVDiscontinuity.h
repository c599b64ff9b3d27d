// SPDX-License-Identifier: BSD-3-Clause
// Which props meet a discontinuity of a projection.
#ifndef vtkWideFoVDiscontinuity_h
#define vtkWideFoVDiscontinuity_h

#include "Projections/Projection.h"

// True where a prop with these world bounds may need the pre-clip: it comes near a seam, a
// pole, the antipode or a face border of the projection, or the view bends too much for any
// mesh. worldToView: row-major, 4 x 4.
bool vtkWideFoVNeedsPreClip(const wfv::Projection& projection, const wfv::WfvView& view,
  const double bounds[6], const double worldToView[16]);

#endif
