// SPDX-License-Identifier: BSD-3-Clause
// Where the eye is where nobody says: inside of what surrounds, outside of a thing.
#ifndef WideFoVFirstView_h
#define WideFoVFirstView_h

#include "Options/Options.h"
#include "Scenes/Scene.h"

#include <vtkBoundingBox.h>

namespace widefov
{
// Completes what the options leave open of the view of files: the eye, by SurroundedPlace or as
// --inside and --outside say, and outside the direction and the field of view that show the scene
// large, and says in one line what it chose. What is given stays. Nothing changes where a point
// to look at is given, in a room of screens or for the poses of a head, and for built-in scenes,
// which have eyes of their own, unless --inside or --outside is given; of films that say where the
// eye goes there is but the up of a globe. From outside, `later` is shown as well: bounds of what
// the scene becomes.
void ChooseView(
  Options& options, const Scene& scene, const vtkBoundingBox& later = vtkBoundingBox());
}

#endif
