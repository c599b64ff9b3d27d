// SPDX-License-Identifier: BSD-3-Clause
// A million small triangles all round.
#ifndef WideFoVBallScenes_h
#define WideFoVBallScenes_h

#include "Scene.h"

namespace wfv
{
namespace bench
{
// Balls of 8,064 triangles each, a prop a ball, spread evenly over the directions from the origin,
// 1,024,128 triangles in all: about two pixels each in a picture of 2048x1024. apart: as many, but
// closer together, for none of them meets the seam or a pole of an equirectangular map.
widefov::Scene MakeBallScene(bool apart);
}
}

#endif
