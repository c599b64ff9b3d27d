// SPDX-License-Identifier: BSD-3-Clause
#include "ImageOutput.h"

#include "GPano.h"
#include "Messages.h"
#include "OptionValues.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <memory>

namespace widefov
{
namespace
{
constexpr int JpegQuality = 95; // percent

struct Format
{
  const char* Ending;
  const char* Writer; // OpenImageIO's name
};

const std::vector<Format> Formats{ { ".png", "png" }, { ".jpg", "jpeg" }, { ".jpeg", "jpeg" },
  { ".tif", "tiff" }, { ".tiff", "tiff" }, { ".exr", "openexr" } };

std::string WriterFor(const std::string& path)
{
  std::string ending = std::filesystem::path(path).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const auto format = std::find_if(
    Formats.begin(), Formats.end(), [&](const Format& f) { return ending == f.Ending; });
  return format == Formats.end() ? "" : format->Writer;
}

void AddEnvironment(OIIO::ImageSpec& spec, const PanoramaInfo& info)
{
  spec.attribute("compression", "zip");
  // a latitude-longitude environment is the whole sphere by definition
  if (info.Equirectangular && info.HorizontalFov == 360 && info.VerticalFov == 180)
  {
    spec.attribute("textureformat", "LatLong Environment");
  }
}

void AddGPano(OIIO::ImageSpec& spec, const PanoramaInfo& info)
{
  for (const GPanoField& field : GPanoFields(spec.width, spec.height, info))
  {
    spec.attribute("GPano:" + field.Name, field.Value);
  }
}

std::vector<unsigned char> Encode(
  const std::string& writer, const OIIO::ImageSpec& spec, OIIO::TypeDesc type, const void* pixels)
{
  const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create(writer);
  if (!output)
  {
    Fail("OpenImageIO has no writer for " + writer + ": " + OIIO::geterror() + "; install one");
  }
  OIIO::Filesystem::IOVecOutput memory;
  output->set_ioproxy(&memory);
  if (!output->open("memory." + writer, spec) || !output->write_image(type, pixels) ||
    !output->close())
  {
    Fail("the picture cannot be encoded as " + writer + ": " + output->geterror() +
      "; choose another format or size");
  }
  return memory.buffer();
}
}

void CheckPictureName(const std::string& path)
{
  if (WriterFor(path).empty())
  {
    FailUsage("--output: '" + path + "' does not end in .png, .jpg, .tif or .exr; choose one");
  }
}

void CheckAovName(const std::string& path)
{
  if (WriterFor(path) != "openexr")
  {
    FailUsage("--aov: '" + path + "' does not end in .exr; rename it");
  }
}

std::vector<unsigned char> EncodePicture(
  const Picture& picture, const std::string& path, const PanoramaInfo& info)
{
  const std::string writer = WriterFor(path);
  const bool exr = writer == "openexr";
  OIIO::ImageSpec spec(
    picture.Width, picture.Height, 3, exr ? OIIO::TypeDesc::FLOAT : OIIO::TypeDesc::UINT8);
  spec.attribute("Software", "VTKWideFoV " + GetProgramName());
  if (exr)
  {
    AddEnvironment(spec, info);
  }
  else if (info.Equirectangular && writer != "png")
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
  std::vector<unsigned char> bytes =
    Encode(writer, spec, OIIO::TypeDesc::UINT8, picture.Rgb.data());
  if (writer == "png" && info.Equirectangular)
  {
    InsertPngXmp(bytes, GPanoXmp(picture.Width, picture.Height, info));
  }
  return bytes;
}

std::vector<unsigned char> EncodeFloats(const FloatPicture& picture, const PanoramaInfo& info)
{
  OIIO::ImageSpec spec(picture.Width, picture.Height, static_cast<int>(picture.Channels.size()),
    OIIO::TypeDesc::FLOAT);
  spec.channelnames = picture.Channels;
  spec.attribute("Software", "VTKWideFoV " + GetProgramName());
  AddEnvironment(spec, info);
  return Encode("openexr", spec, OIIO::TypeDesc::FLOAT, picture.Values.data());
}
}
