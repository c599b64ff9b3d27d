// SPDX-License-Identifier: BSD-3-Clause
// Normals for surfaces that have none.
#ifndef WideFoVNormals_h
#define WideFoVNormals_h

#include "Scene.h"

namespace widefov
{
// Smooth ones, sharp at edges, for surfaces of polygons without normals. Cells keep their order.
void SmoothNormals(Scene& scene);
}

#endif
