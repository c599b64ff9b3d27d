// SPDX-License-Identifier: BSD-3-Clause
// Whether a scene is a thing, to be seen from outside, or lies all round.
#ifndef WideFoVSurroundings_h
#define WideFoVSurroundings_h

#include "Scene.h"

#include <optional>

namespace widefov
{
// A place that the scene surrounds, in or near the middle of its bounds; nothing where it is a
// thing to be seen from outside. It surrounds what is inside of a flow (arrows and stream lines of
// 3-D data), of a 3-D grid, of a globe of longitudes and latitudes, and else a place from which
// most directions end on a surface that faces it and which sees at least two fifths of the bounds'
// volume. Surfaces are asked at the middle and at six places round it: most of them must agree.
// Images and what is drawn as a volume are things: from inside they are fog.
std::optional<Vector3> SurroundedPlace(const Scene& scene);

// Where vtkWideFoVRenderer::ResetCameraInside puts the eye.
Vector3 FreePlace(const Scene& scene);
}

#endif
