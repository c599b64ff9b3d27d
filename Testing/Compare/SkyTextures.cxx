// SPDX-License-Identifier: BSD-3-Clause
#include "SkyTextures.h"

#include <vtkNew.h>
#include <vtkVersion.h>

#include <algorithm>
#include <cmath>

namespace wfv
{
namespace test
{
namespace
{
int RunningVtk()
{
  return 100 * vtkVersion::GetVTKMajorVersion() + vtkVersion::GetVTKMinorVersion();
}

// Since 9.6 a sphere's middle is what is on the right, before what is ahead.
bool BeginsAhead()
{
  return RunningVtk() < 906;
}

// Of a cube, VTK 9.1 takes the direction as it is; later ones look at it from behind.
vec3 CubeDirection(const vec3& d)
{
  return RunningVtk() < 902 ? d : vec3(d.x, d.y, -d.z);
}

// The direction of a place on a face, as OpenGL numbers and turns them; from -1 to 1.
vec3 OnFace(int face, double s, double t)
{
  const vec3 faces[6] = { vec3(1, -t, -s), vec3(-1, -t, s), vec3(s, 1, t), vec3(s, -1, -t),
    vec3(s, -t, 1), vec3(-s, -t, -1) };
  return faces[face];
}

int Wrapped(int i, int n)
{
  return ((i % n) + n) % n;
}

vtkSmartPointer<vtkTexture> Bilinear(bool mipmap)
{
  auto texture = vtkSmartPointer<vtkTexture>::New();
  texture->InterpolateOn();
  texture->SetMipmap(mipmap);
  return texture;
}
}

SkyImage::SkyImage(int width, int height, const std::function<SkyColor(vec2)>& color)
  : Image(vtkSmartPointer<vtkImageData>::New())
{
  this->Image->SetDimensions(width, height, 1);
  this->Image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  for (int y = 0; y < height; y++)
  {
    for (int x = 0; x < width; x++)
    {
      const SkyColor c = color(vec2((x + 0.5) / width, (y + 0.5) / height));
      auto* const texel = static_cast<unsigned char*>(this->Image->GetScalarPointer(x, y, 0));
      for (int i = 0; i < 3; i++)
      {
        texel[i] = static_cast<unsigned char>(std::lround(std::clamp(c[i], 0.0, 255.0)));
      }
    }
  }
}

SkyColor SkyImage::Texel(int x, int y) const
{
  const int* const size = this->Image->GetDimensions();
  const auto* const texel = static_cast<const unsigned char*>(
    this->Image->GetScalarPointer(Wrapped(x, size[0]), Wrapped(y, size[1]), 0));
  return SkyColor(texel[0], texel[1], texel[2]);
}

SkyColor SkyImage::Tiled(vec2 place) const
{
  const int* const size = this->Image->GetDimensions();
  const vec2 at = place * vec2(size[0], size[1]) - 0.5;
  const vec2 first = glm::floor(at);
  const vec2 t = at - first;
  const int x = static_cast<int>(first.x);
  const int y = static_cast<int>(first.y);
  return (1 - t.y) * ((1 - t.x) * this->Texel(x, y) + t.x * this->Texel(x + 1, y)) +
    t.y * ((1 - t.x) * this->Texel(x, y + 1) + t.x * this->Texel(x + 1, y + 1));
}

SkyColor SkyImage::At(vec2 place, double low, double high) const
{
  const double half = 0.5 / this->Image->GetDimensions()[1];
  return this->Tiled(vec2(place.x, std::clamp(place.y, low + half, high - half)));
}

SkyColor SmoothColor(const vec3& direction)
{
  const vec3 d = glm::normalize(direction);
  return SkyColor(128 + 100 * d.x, 128 + 100 * d.y, 128 + 60 * d.z + 40 * d.x * d.y);
}

vec2 SpherePlace(const vec3& d)
{
  const double turn = BeginsAhead() ? std::atan2(d.x, -d.z) : std::atan2(d.z, d.x);
  return vec2(0.5 * turn, std::atan2(d.y, std::hypot(d.x, d.z))) / WFV_PI + 0.5;
}

vec3 SphereDirection(const vec2& place)
{
  const double turn = 2 * WFV_PI * (place.x - 0.5);
  const double height = WFV_PI * (place.y - 0.5);
  const vec2 level = std::cos(height) * vec2(std::sin(turn), std::cos(turn));
  return BeginsAhead() ? vec3(level.x, std::sin(height), -level.y)
                       : vec3(level.y, std::sin(height), level.x);
}

vtkSmartPointer<vtkTexture> SphereTexture(const SkyImage& image, bool mipmap)
{
  vtkSmartPointer<vtkTexture> texture = Bilinear(mipmap);
  texture->SetInputData(image.GetImage());
  return texture;
}

vtkSmartPointer<vtkTexture> CubeTexture(int size, bool mipmap)
{
  vtkSmartPointer<vtkTexture> texture = Bilinear(mipmap);
  texture->CubeMapOn();
  for (int face = 0; face < 6; face++)
  {
    const SkyImage image(size, size, [face](vec2 place) {
      return SmoothColor(CubeDirection(OnFace(face, 2 * place.x - 1, 2 * place.y - 1)));
    });
    texture->SetInputDataObject(face, image.GetImage());
  }
  return texture;
}
}
}
