// SPDX-License-Identifier: BSD-3-Clause
// A window may show a tile of a picture: what the whole picture is like.
#ifndef WideFoVTile_h
#define WideFoVTile_h

#include "Projections/ProjectionMath.h"
#include "vtkWideFoVAbi.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkRenderer;
class vtkShaderProgram;
VTK_ABI_NAMESPACE_END

namespace wfv
{
// Where the window's share begins in the renderer's whole picture, from its lower left corner,
// and how large the two are, pixels.
struct TilePixels
{
  vec2 Full;
  vec2 Start;
  vec2 Size;
};

TilePixels PixelsOfTile(vtkRenderer* renderer);

// Width over height of the renderer's whole picture, in pixels. That of vtkRenderer is the
// tile's.
double PictureAspect(vtkRenderer* renderer);

// The uniforms by which pixels and the map's own coordinates are turned into each other; tile: NDC
// of the tile = NDC of the picture * first two + last two; viewport: of OpenGL, which a pass may
// have made larger; scale: NDC per unit of the raw map; center: NDC of the picture where the map's
// are 0.
void SetTileUniforms(vtkShaderProgram* program, const TilePixels& pixels, const float tile[4],
  const int viewport[4], const vec2& scale, const vec2& center);
}

#endif
