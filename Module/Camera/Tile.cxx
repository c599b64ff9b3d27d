// SPDX-License-Identifier: BSD-3-Clause
#include "Camera/Tile.h"

#include "Camera/TwoFloats.h"

#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkWindow.h"

#include <algorithm>
#include <cmath>

namespace
{
// Relative: what the products of an aspect may be off by.
constexpr double AspectRounding = 1e-12;
}

namespace wfv
{
TilePixels PixelsOfTile(vtkRenderer* renderer)
{
  const double* const vp = renderer->GetViewport();
  const double* const tile = renderer->GetVTKWindow()->GetTileViewport();
  const int* const window = renderer->GetVTKWindow()->GetSize();
  int size[2];
  int origin[2];
  renderer->GetTiledSizeAndOrigin(&size[0], &size[1], &origin[0], &origin[1]);
  TilePixels pixels;
  for (int i = 0; i < 2; i++)
  {
    const auto pixel = [=](double place) { return std::floor(place * window[i] + 0.5); };
    const double shown = std::max(1, size[i]);
    const bool whole = tile[i] <= vp[i] && tile[i + 2] >= vp[i + 2];
    pixels.Size[i] = shown;
    pixels.Full[i] = whole ? shown : std::max(1.0, pixel(vp[i + 2]) - pixel(vp[i]));
    pixels.Start[i] = whole ? 0 : pixel(std::max(vp[i], tile[i])) - pixel(vp[i]);
  }
  return pixels;
}

double PictureAspect(vtkRenderer* renderer)
{
  const double aspect = renderer->GetTiledAspectRatio();
  if (renderer->GetVTKWindow() == nullptr)
  {
    return aspect;
  }
  const TilePixels pixels = PixelsOfTile(renderer);
  if (pixels.Full == pixels.Size)
  {
    return aspect;
  }
  // a renderer may have an aspect of its own; rounding is none
  const double own = aspect * pixels.Size.y / pixels.Size.x;
  return (std::abs(own - 1) < AspectRounding ? 1 : own) * pixels.Full.x / pixels.Full.y;
}

void SetTileUniforms(vtkShaderProgram* program, const TilePixels& pixels, const float tile[4],
  const int viewport[4], const vec2& scale, const vec2& center)
{
  // in whole and half pixels, so that a tile has the very rays of the whole picture
  float toMap[4];
  float picture[4];
  float toMapLow[2];
  float shown[4];
  float quarter[2]; // pixels of a quarter turn, where the map's unit is the radian
  for (int i = 0; i < 2; i++)
  {
    const double larger = viewport[i + 2] / pixels.Size[i];
    const double whole = pixels.Full[i] * larger;
    const double start = pixels.Start[i] * larger;
    const double aside = 0.5 * whole * center[i];
    shown[i] = tile[i];
    shown[i + 2] = static_cast<float>(tile[i + 2] + tile[i] * center[i]);
    picture[i] = static_cast<float>(viewport[i] - start + aside);
    picture[i + 2] = static_cast<float>(whole);
    toMap[i] = static_cast<float>(viewport[i] + 0.5 * whole - start + aside);
    toMap[i + 2] = static_cast<float>(2 / (whole * scale[i]));
    toMapLow[i] = LowPart(2 / (whole * scale[i]));
    quarter[i] = static_cast<float>(0.25 * WFV_PI * whole * scale[i]);
  }
  const float f[4] = { static_cast<float>(viewport[0]), static_cast<float>(viewport[1]),
    static_cast<float>(viewport[2]), static_cast<float>(viewport[3]) };
  program->SetUniform4f("wfvTile", shown);
  program->SetUniform4f("wfvViewport", f);
  program->SetUniform4f("wfvPixelToMap", toMap);
  program->SetUniform2f("wfvPixelToMapLow", toMapLow);
  program->SetUniform4f("wfvPicture", picture);
  program->SetUniform2f("wfvQuarterTurn", quarter);
}
}
