// SPDX-License-Identifier: BSD-3-Clause
// Textures of skies, and what they show in a direction: in double.
#ifndef WideFoVTestSkyTextures_h
#define WideFoVTestSkyTextures_h

#include "Projections/Projection.h"

#include <vtkImageData.h>
#include <vtkSmartPointer.h>
#include <vtkTexture.h>

#include <functional>

namespace wfv
{
namespace test
{
// Levels of red, green and blue, 0 to 255.
using SkyColor = vec3;

// A picture with a colour for each texel; and what OpenGL shows at a place of it, from 0 to 1.
class SkyImage
{
public:
  // color: of the place of a texel's centre.
  SkyImage(int width, int height, const std::function<SkyColor(vec2)>& color);

  // Between four texels, going round from side to side; upwards from the height `low` to `high`,
  // beyond which nothing is mixed in.
  SkyColor At(vec2 place, double low = 0, double high = 1) const;

  // Going on upwards as well.
  SkyColor Tiled(vec2 place) const;

  vtkImageData* GetImage() const { return this->Image; }

private:
  SkyColor Texel(int x, int y) const;

  vtkSmartPointer<vtkImageData> Image;
};

// Colours that change smoothly with the direction, all round, no two faces alike.
SkyColor SmoothColor(const vec3& direction);

// Where VTK looks a direction up in a sphere's texture; upright skies.
vec2 SpherePlace(const vec3& direction);

// Its inverse.
vec3 SphereDirection(const vec2& place);

// Texture of a sphere, bilinear.
vtkSmartPointer<vtkTexture> SphereTexture(const SkyImage& image, bool mipmap);

// Texture of a cube whose faces have so many texels a side, and show SmoothColor.
vtkSmartPointer<vtkTexture> CubeTexture(int size, bool mipmap);
}
}

#endif
