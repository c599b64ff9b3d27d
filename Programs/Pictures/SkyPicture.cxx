// SPDX-License-Identifier: BSD-3-Clause
#include "SkyPicture.h"

#include "System/CrashGuard.h"
#include "System/Progress.h"
#include "Text/Messages.h"

#include <OpenImageIO/imageio.h>

#include <vtkImageData.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkRenderer.h>
#include <vtkSkybox.h>
#include <vtkTexture.h>
#include <vtkWideFoVRenderer.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <vector>

namespace widefov
{
namespace
{
// Bytes of a picture in memory at the most.
constexpr double LargestSky = 4e9;

void CheckSpec(const std::string& path, const OIIO::ImageSpec& spec)
{
  const double bytes = 4.0 * spec.width * spec.height * std::max(3, spec.nchannels);
  if (spec.width < 1 || spec.height < 1 || spec.nchannels < 1 || bytes > LargestSky)
  {
    Fail(path + " has " + std::to_string(spec.width) + "x" + std::to_string(spec.height) +
      " pixels of " + std::to_string(spec.nchannels) + " channels; give a smaller picture");
  }
}

// Red, green and blue, the bottom row first. Values: as the file has them.
template <typename Value>
vtkSmartPointer<vtkImageData> Read(const std::string& path, OIIO::ImageInput& input,
  const OIIO::ImageSpec& spec, OIIO::TypeDesc type, int vtkType)
{
  const std::size_t channels = spec.nchannels;
  std::vector<Value> all(channels * spec.width * spec.height);
  if (!input.read_image(0, 0, 0, spec.nchannels, type, all.data()))
  {
    Fail(path + " cannot be read: " + input.geterror() + "; check the file");
  }
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(spec.width, spec.height, 1);
  image->AllocateScalars(vtkType, 3);
  auto* out = static_cast<Value*>(image->GetScalarPointer());
  for (int row = spec.height - 1; row >= 0; row--)
  {
    const Value* in = &all[channels * spec.width * row];
    for (int column = 0; column < spec.width; column++, in += channels)
    {
      for (int i = 0; i < 3; i++)
      {
        *out++ = in[channels < 3 ? 0 : i]; // grey, or grey with an alpha
      }
    }
  }
  return image;
}

// Of what is not the light of anything.
void MakeFinite(vtkImageData* image)
{
  auto* const values = static_cast<float*>(image->GetScalarPointer());
  std::replace_if(
    values, values + 3 * image->GetNumberOfPoints(),
    [](float v) { return !std::isfinite(v) || v < 0; }, 0.0f);
}

// Turns +y to up, by the shortest way; keeps what is across.
std::array<double, 3> Upright(const Vector3& up, const std::array<double, 3>& v)
{
  const double length = std::sqrt(up[0] * up[0] + up[1] * up[1] + up[2] * up[2]);
  const std::array<double, 3> u{ { up[0] / length, up[1] / length, up[2] / length } };
  if (u[1] < -1 + 1e-12)
  {
    return { { v[0], -v[1], -v[2] } };
  }
  // Rodrigues, about (0, 1, 0) x u
  const std::array<double, 3> axis{ { u[2], 0, -u[0] } };
  std::array<double, 3> side;
  vtkMath::Cross(axis.data(), v.data(), side.data());
  const double along = vtkMath::Dot(axis.data(), v.data()) / (1 + u[1]);
  return { { v[0] * u[1] + side[0] + axis[0] * along, v[1] * u[1] + side[1] + axis[1] * along,
    v[2] * u[1] + side[2] + axis[2] * along } };
}

vtkSmartPointer<vtkSkybox> MakeSky(
  vtkImageData* image, const std::array<double, 3>& up, const std::array<double, 3>& right)
{
  vtkNew<vtkTexture> texture;
  texture->SetInputData(image);
  texture->InterpolateOn();
  texture->MipmapOn();
  texture->SetColorModeToDirectScalars();
  auto sky = vtkSmartPointer<vtkSkybox>::New();
  sky->SetTexture(texture);
  sky->SetProjectionToSphere();
  sky->SetGammaCorrect(image->GetScalarType() == VTK_FLOAT); // light as it is measured
  sky->SetFloorPlane(
    static_cast<float>(up[0]), static_cast<float>(up[1]), static_cast<float>(up[2]), 0);
  sky->SetFloorRight(
    static_cast<float>(right[0]), static_cast<float>(right[1]), static_cast<float>(right[2]));
  return sky;
}
}

void LoadSky(Options& o)
{
  if (o.Sky.empty())
  {
    return;
  }
  const std::string& path = o.Sky;
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error))
  {
    Fail(
      path + " is not there, or no file; give a picture of all directions, twice as wide as high");
  }
  const Progress progress("reading " + path);
  const CrashGuard guard(path + " cannot be read: it is damaged; check the file");
  const std::unique_ptr<OIIO::ImageInput> input = OIIO::ImageInput::open(path);
  if (!input)
  {
    Fail(path + " is no picture that can be read: " + OIIO::geterror() +
      "; give one as .hdr, .exr, .jpg, .png or .tif");
  }
  const OIIO::ImageSpec spec = input->spec();
  CheckSpec(path, spec);
  const bool bytes = spec.format == OIIO::TypeDesc::UINT8;
  o.SkyPicture = bytes
    ? Read<unsigned char>(path, *input, spec, OIIO::TypeDesc::UINT8, VTK_UNSIGNED_CHAR)
    : Read<float>(path, *input, spec, OIIO::TypeDesc::FLOAT, VTK_FLOAT);
  if (!bytes)
  {
    MakeFinite(o.SkyPicture);
  }
}

void SetBackground(vtkRenderer* renderer, const Options& o)
{
  renderer->SetBackground(o.Background.data());
  const Vector3 up = o.Up.value_or(Vector3{ { 0, 1, 0 } });
  const std::array<double, 3> top = Upright(up, { { 0, 1, 0 } });
  // from 9.6 on skies are turned by the renderer, and have their middle on its right
  const std::array<double, 3> right = Upright(up, { { 0, 0, -1 } });
  renderer->SetEnvironmentUp(top[0], top[1], top[2]);
  renderer->SetEnvironmentRight(right[0], right[1], right[2]);
  auto* const wide = vtkWideFoVRenderer::SafeDownCast(renderer);
  if (o.Zenith && wide)
  {
    renderer->SetBackground2(o.Zenith->data());
    renderer->GradientBackgroundOn();
    wide->GradientByDirectionOn();
  }
  if (o.SkyPicture)
  {
    renderer->AddActor(MakeSky(o.SkyPicture, top, Upright(up, { { 1, 0, 0 } })));
  }
}
}
