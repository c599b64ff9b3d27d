// SPDX-License-Identifier: BSD-3-Clause
// The sphere that a picture was made of, for looking at it from a seat; or the
// screens of a room.
#ifndef WideFoVDome_h
#define WideFoVDome_h

#include "Options/Options.h"

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

namespace widefov
{
// What a wide view shows on the unit sphere round its eye, in view coordinates, with the places in
// the picture as texture coordinates (0 to 1 from the lower left). Where neighbours in the picture
// are none on the sphere, at the borders of a cube's faces, nothing is.
vtkSmartPointer<vtkPolyData> MakeDome(const Options& options);

// A flat screen where it stands in its room, with the places of its picture.
vtkSmartPointer<vtkPolyData> MakeScreen(const wfv::Screen& corners);
}

#endif
