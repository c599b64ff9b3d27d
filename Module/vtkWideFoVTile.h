// SPDX-License-Identifier: BSD-3-Clause
// A window may show a tile of a picture: what the whole picture is like.
#ifndef vtkWideFoVTile_h
#define vtkWideFoVTile_h

#include "Projections/ProjectionMath.h"

#include "vtkRenderer.h"
#include "vtkWindow.h"

#include <algorithm>

namespace wfv
{
// The window's share of the renderer's viewport, along both axes: 1 where there are no tiles.
inline vec2 TileShare(vtkRenderer* renderer)
{
  const double* const vp = renderer->GetViewport();
  const double* const tile = renderer->GetVTKWindow()->GetTileViewport();
  const auto share = [=](int i) {
    const double shown = std::min(vp[i + 2], tile[i + 2]) - std::max(vp[i], tile[i]);
    return shown > 0 ? shown / (vp[i + 2] - vp[i]) : 1;
  };
  return { share(0), share(1) };
}

// Width over height of the renderer's whole picture, in pixels. That of vtkRenderer is the
// tile's.
inline double PictureAspect(vtkRenderer* renderer)
{
  const double aspect = renderer->GetTiledAspectRatio();
  if (renderer->GetVTKWindow() == nullptr)
  {
    return aspect;
  }
  const vec2 share = TileShare(renderer);
  return aspect * share.y / share.x;
}
}

#endif
