// SPDX-License-Identifier: BSD-3-Clause
#include "ImageSpec.h"

#include "Options/OutputNames.h"

#include "GPano.h"
#include "Text/Messages.h"

namespace widefov
{
namespace
{
constexpr int JpegQuality = 95; // percent

void AddEnvironment(OIIO::ImageSpec& spec, const PanoramaInfo& info)
{
  spec.attribute("compression", "zip");
  // a latitude-longitude environment is the whole sphere by definition
  if (info.Equirectangular && info.StereoMode.empty() && info.Whole[0] == 0 &&
    info.HorizontalFov == 360 && info.VerticalFov == 180)
  {
    spec.attribute("textureformat", "LatLong Environment");
  }
}

void AddGPano(OIIO::ImageSpec& spec, const PanoramaInfo& info)
{
  for (const wfvxmp::Field& field : GPanoFields(spec.width, spec.height, info))
  {
    spec.attribute("GPano:" + field.Name, field.Value);
  }
}
}

OIIO::ImageSpec PictureSpec(
  int width, int height, const std::string& path, const PanoramaInfo& info)
{
  const std::string writer = WriterFor(path);
  const bool exr = writer == "openexr";
  OIIO::ImageSpec spec(width, height, 3, exr ? OIIO::TypeDesc::FLOAT : OIIO::TypeDesc::UINT8);
  spec.attribute("Software", "VTKWideFoV " + GetProgramName());
  if (!info.Description.empty())
  {
    spec.attribute("ImageDescription", info.Description);
  }
  if (exr)
  {
    AddEnvironment(spec, info);
  }
  else if (info.Equirectangular && writer != "png" && info.StereoMode.empty())
  {
    AddGPano(spec, info);
  }
  if (writer == "jpeg")
  {
    spec.attribute("CompressionQuality", JpegQuality);
  }
  if (writer == "tiff")
  {
    spec.attribute("compression", "zip");
  }
  return spec;
}

OIIO::ImageSpec FloatSpec(
  int width, int height, const std::vector<std::string>& channels, const PanoramaInfo& info)
{
  OIIO::ImageSpec spec(width, height, static_cast<int>(channels.size()), OIIO::TypeDesc::FLOAT);
  spec.channelnames = channels;
  spec.attribute("Software", "VTKWideFoV " + GetProgramName());
  AddEnvironment(spec, info);
  return spec;
}

std::vector<unsigned char> PngPanorama(
  int width, int height, const std::string& path, const PanoramaInfo& info)
{
  if (WriterFor(path) != "png" || !info.Equirectangular)
  {
    return {};
  }
  return wfvxmp::PngChunk(
    info.StereoMode.empty() ? GPanoXmp(width, height, info) : SphericalXmp(width, height, info));
}
}
