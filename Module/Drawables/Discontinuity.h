// SPDX-License-Identifier: BSD-3-Clause
// Which props meet a discontinuity of a projection.
#ifndef WideFoVDiscontinuity_h
#define WideFoVDiscontinuity_h

#include "Projections/Projection.h"

// True where a prop with these world bounds may need the pre-clip: it comes near a seam, a
// pole, the antipode or a face border of the projection, or the view curves too much for any
// mesh. worldToView: row-major, 4 x 4. footprint: radians by which what is drawn may look larger
// than these bounds, which counts at the borders of the picture too.
bool vtkWideFoVNeedsPreClip(const wfv::Projection& projection, const wfv::WfvView& view,
  const double bounds[6], const double worldToView[16], double footprint = 0);

// How far, in NDC, the edges of a prop with these bounds are from their chords at the most;
// very large where nothing can be said. Scene units.
double vtkWideFoVChordError(const wfv::Projection& projection, const wfv::WfvView& view,
  const double bounds[6], const double worldToView[16], double longestEdge);

#endif
